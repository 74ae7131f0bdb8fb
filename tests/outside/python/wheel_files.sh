#!/usr/bin/env bash
# wheel_files.sh SOURCE PYTHON WHEEL GPL-WHEEL: the two wheels share no file, and the first has nothing of a library under the GPL.
set -euo pipefail
source=$1 python=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "FAILED: $*"; exit 1; }
for file in "$3" "$4"; do
  echo "$(basename "$file"), $(stat -c %s "$file") bytes"
  case $(basename "$file") in
    *-py3-none-manylinux_*.whl | *-py3-none-linux_*.whl) ;;
    *) fail "the tag of $file is not py3-none-manylinux_*" ;;
  esac
done
"$python" -m zipfile -e "$3" "$scratch/free"
"$python" -m zipfile -e "$4" "$scratch/gpl"
for tree in free gpl; do (cd "$scratch/$tree" && find . -type f | sort >"../$tree.txt"); done
! comm -12 "$scratch/free.txt" "$scratch/gpl.txt" | grep . || fail "both wheels have these files"
parts=$scratch/gpl/roughcontact/lib
"$python" -B "$source/tests/outside/python/free_of_gpl.py" "$scratch/free" -- \
  "$parts"/libroughcontact-{surface,flow}.so.0 "$parts"/roughcontact-command-gpl "$parts"/roughcontact/abi-*
