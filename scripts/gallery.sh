#!/usr/bin/env bash
# gallery.sh BUILD [--update] [NAME...]: runs the notebooks of docs/gallery with the library of BUILD; --update renews their pictures.
# Exit code 77 where what they need cannot be had.
set -euo pipefail
[ $# -gt 0 ] || { echo "usage: $0 BUILD [--update] [NAME...]"; exit 1; }
build=$(cd "$1" && pwd)
shift
cd "$(dirname "$0")/.."
python=$(scripts/docs-venv.sh "$build")
export PYTHONPATH=$PWD/bindings/python PYTHONDONTWRITEBYTECODE=1 ROUGHCONTACT_LIBRARY=$build/lib/libroughcontact.so
exec "$python" tests/outside/docs/gallery.py "$@"
