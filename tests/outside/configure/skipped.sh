#!/usr/bin/env bash
# skipped.sh SOURCE FOLDER: .ci/skipped.sh finds families of tests that are skipped as a whole.
set -euo pipefail
source=$1 folder=$2
mkdir -p "$folder"
printf '#!/bin/sh\nprintf %%s "$STATUS"\n' >"$folder/dpkg-query"
chmod +x "$folder/dpkg-query"
export PATH=$folder:$PATH
line() { printf '%3d/9 Test #%d: %s .........%s\n' "$1" "$1" "$2" "$3"; }
failed() { echo "$1"; exit 1; }

{ line 1 plain.one '   Passed    0.10 sec'; line 2 plain.two '***Skipped   0.01 sec'; line 3 lone.one '***Failed    0.10 sec'; } >"$folder/some.log"
STATUS=installed "$source/.ci/skipped.sh" "$folder/some.log" || failed "no family is skipped as a whole"
{ cat "$folder/some.log"; line 4 absent.one '***Skipped   0.01 sec'; line 5 absent.two '***Skipped   0.01 sec'; } >"$folder/whole.log"
! found=$(STATUS=installed "$source/.ci/skipped.sh" "$folder/whole.log") || failed "a family that is skipped as a whole passes"
[ "$found" = "skipped as a whole, although everything is installed: absent" ] || failed "$found"
STATUS='' "$source/.ci/skipped.sh" "$folder/whole.log" >"$folder/said" || failed "what is not installed may be skipped"
grep -q "perhaps for want of abigail-tools: absent" "$folder/said" || failed "$(cat "$folder/said")"
