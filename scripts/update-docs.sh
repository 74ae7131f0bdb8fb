#!/usr/bin/env bash
# update-docs.sh BUILD: renews every text that is generated from the build at BUILD. The measured ones are bench/documents.sh's.
set -euo pipefail
[ $# = 1 ] || { echo "usage: $0 BUILD"; exit 1; }
build=$(cd "$1" && pwd)
cd "$(dirname "$0")/.."
cmake --build "$build" -j "$(nproc)" --target test_errors roughcontact rcb_fft rcb_split rcb_cholmod >/dev/null
export PYTHONDONTWRITEBYTECODE=1
python3 tests/contract/errors/document.py "$build/bin/test_errors" docs/development/errors.md --update
python3 tests/outside/docs/options.py . "$build/lib/libroughcontact.so.0" --update
git status --short docs bindings
