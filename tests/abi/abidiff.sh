#!/usr/bin/env bash
# abidiff.sh SOURCE CC: compares the interface of the public headers with that of the last release, by libabigail: functions,
# argument types and layouts, whatever the libraries were built with. Additions pass. Exits with 77 where there is no release tag
# (v1.2.3) in this clone, where the ABI number has changed since, or without libabigail.
set -euo pipefail
source=$1 cc=$2
here=$(cd "$(dirname "$0")" && pwd)
tag=$(git -C "$source" describe --tags --match 'v[0-9]*' --abbrev=0 2>/dev/null) || { echo "skipped: no release tag"; exit 77; }
command -v abidiff >/dev/null || { echo "skipped: abidiff (Debian: abigail-tools) is not installed"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

mkdir "$scratch/now" "$scratch/then"
cp -r "$source/include" "$scratch/now"
git -C "$source" archive "$tag" include | tar -x -C "$scratch/then"
abi() { sed -nE 's/^#define RC_ABI ([0-9]+).*/\1/p' "$scratch/$1/include/roughcontact/roughcontact.h"; }
[ "$(abi now)" = "$(abi then)" ] || { echo "skipped: RC_ABI has changed since $tag"; exit 77; }

failed=0
for headers in "roughcontact plugin" surface; do
  for state in then now; do
    # shellcheck disable=SC2086
    (cd "$scratch/$state/include/roughcontact" && python3 "$here/interface.py" ${headers// /.h }.h >"$scratch/interface.c")
    "$cc" -w -g -fPIC -shared -Wl,-soname,interface "$scratch/interface.c" -o "$scratch/$state.so"
  done
  status=0
  abidiff --no-added-syms "$scratch/then.so" "$scratch/now.so" || status=$?
  [ $((status & 11)) = 0 ] || { echo "$headers: not compatible with $tag, see docs/compatibility.md"; failed=1; }
done
exit $failed
