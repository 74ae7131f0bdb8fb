#!/usr/bin/env bash
# .ci/tidy.sh BUILD: clang-tidy on the library, with the compile commands of a clang build that compiles each file by itself.
set -euo pipefail
cd "$(dirname "$0")/.."
files=$(sed -nE "s#^ *\"file\": \"($PWD/(src|surface)/.*\.cpp)\".*#\1#p" "$1/compile_commands.json" | sort -u)
[ -n "$files" ] || { echo "$1/compile_commands.json has no file of src or surface"; exit 1; }
xargs -d '\n' -P "$(nproc)" -n 2 clang-tidy -p "$1" --quiet 2>/dev/null <<<"$files"
echo "clang-tidy finds nothing"
