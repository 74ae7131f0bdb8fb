#!/usr/bin/env bash
# beside.sh PYTHON "PACKAGE..." ARGUMENT...: pytest with these arguments in a virtual environment that has the packages. Exits with 77
# where pip cannot get them.
set -euo pipefail
python=$1 packages=$2
shift 2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
skip() { echo "skipped: $*"; exit 77; }
"$python" -m venv "$scratch/venv" >"$scratch/log" 2>&1 || skip "$python makes no virtual environment (Debian: python3-venv)"
# shellcheck disable=SC2086
PYTHONPATH='' "$scratch/venv/bin/pip" install -q "numpy>=1.21" "pytest>=7" $packages >"$scratch/log" 2>&1 ||
  skip "pip cannot get $packages: $(tail -1 "$scratch/log")"
"$scratch/venv/bin/python" -m pytest -q -p no:cacheprovider "$@"
