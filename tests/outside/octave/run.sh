#!/usr/bin/env bash
# run.sh OCTAVE SCRIPT FOLDER...: runs a script with these folders on Octave's path, without the user's settings.
set -euo pipefail
octave=$1 script=$2
shift 2
[ -n "$octave" ] || { echo "skipped: Octave with mkoctfile is not installed (Debian: octave-dev)"; exit 77; }
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
paths=()
for folder in "$@"; do paths+=(--path "$folder"); done
HOME=$home "$octave" --no-init-file --no-history --quiet "${paths[@]}" "$script"
