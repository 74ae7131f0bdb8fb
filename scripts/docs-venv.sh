#!/usr/bin/env bash
# docs-venv.sh BUILD: makes a virtual environment with docs/requirements.txt in BUILD, where there is none, and prints its Python.
# Exit code 77 where pip cannot get them.
set -euo pipefail
[ $# = 1 ] || { echo "usage: $0 BUILD"; exit 1; }
mkdir -p "$1"
venv=$(cd "$1" && pwd)/docs-venv
requirements=$(cd "$(dirname "$0")/.." && pwd)/docs/requirements.txt
if ! cmp -s "$requirements" "$venv/requirements.txt"; then
  { python3 -m venv --clear "$venv" && PYTHONPATH='' "$venv/bin/pip" install -q -r "$requirements"; } >"$venv.log" 2>&1 ||
    { echo "skipped: $(tail -n 1 "$venv.log")" >&2; exit 77; }
  cp "$requirements" "$venv"
fi
echo "$venv/bin/python"
