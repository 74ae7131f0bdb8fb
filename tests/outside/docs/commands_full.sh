#!/usr/bin/env bash
# commands_full.sh BUILD: all commands of the documents, those that need packages of docs/requirements.txt included.
set -euo pipefail
here=$(dirname "$0")
python=$("$here/../../../scripts/docs-venv.sh" "$1")
exec "$python" -B "$here/commands.py" "$1" --full
