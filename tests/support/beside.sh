#!/usr/bin/env bash
# beside.sh PYTHON PACKAGES ARGUMENT...: Python with these arguments in a virtual environment that has the packages (in one word).
# Exits with 77 where pip cannot get them.
set -euo pipefail
python=$1
read -ra packages <<<"$2"
shift 2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
skip() { echo "skipped: $*"; exit 77; }
"$python" -m venv "$scratch/venv" >"$scratch/log" 2>&1 || skip "$python makes no virtual environment (Debian: python3-venv)"
PYTHONPATH='' "$scratch/venv/bin/pip" install -q "${packages[@]}" >"$scratch/log" 2>&1 ||
  skip "pip cannot get ${packages[*]}: $(tail -1 "$scratch/log")"
"$scratch/venv/bin/python" "$@"
