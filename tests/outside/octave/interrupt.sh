#!/usr/bin/env bash
# interrupt.sh OCTAVE FOLDER: Ctrl-C ends a long rc_solve at once, and Octave unwinds as from its own functions.
set -euo pipefail
octave=$1 folder=$2
[ -n "$octave" ] || { echo "skipped: Octave with mkoctfile is not installed (Debian: octave-dev)"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
script=$(dirname "$(readlink -f "$0")")/interrupt.m

HOME=$scratch "$octave" --no-init-file --no-history --quiet --path "$folder" "$script" >"$scratch/log" 2>&1 &
job=$!
for ((tenth = 0; tenth < 300; ++tenth)); do
  ! grep -q solving "$scratch/log" || break
  sleep 0.1
done
sleep 0.5
kill -INT $job
begun=$SECONDS
wait $job || true
cat "$scratch/log"
grep -q unwound "$scratch/log" || { echo "FAILED: not unwound"; exit 1; }
! grep -q "went on" "$scratch/log" || { echo "FAILED: went on"; exit 1; }
[ $((SECONDS - begun)) -le 20 ] || { echo "FAILED: $((SECONDS - begun)) s until it ended"; exit 1; }
echo "ended within $((SECONDS - begun)) s"
