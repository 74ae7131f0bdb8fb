#!/usr/bin/env bash
# beside.sh PYTHON PACKAGE ARGUMENT...: pytest with these arguments in a virtual environment that has the package. Exits with 77
# where pip cannot get it.
set -euo pipefail
python=$1 package=$2
shift 2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
skip() { echo "skipped: $*"; exit 77; }
"$python" -m venv "$scratch/venv" >"$scratch/log" 2>&1 || skip "$python makes no virtual environment (Debian: python3-venv)"
PYTHONPATH='' "$scratch/venv/bin/pip" install -q "numpy>=1.21" "pytest>=7" "$package" >"$scratch/log" 2>&1 ||
  skip "pip cannot get $package: $(tail -1 "$scratch/log")"
"$scratch/venv/bin/python" -m pytest -q -p no:cacheprovider "$@"
