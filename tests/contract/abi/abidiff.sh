#!/usr/bin/env bash
# abidiff.sh SOURCE CC: compares the interface of the public headers with that of the last release, by libabigail: functions,
# argument types and layouts, whatever the libraries were built with. New functions and structs that grow at their end pass. Exits
# with 77 where there is no release tag (v1.2.3) in this clone, where the ABI number has changed since, or without libabigail.
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
# Lines of a report where structs have grown at their end. A member in between moves others, which is another line. The tool's own
# rule for structs that grow lets a member of another type pass.
grown="^$|^[A-Z][A-Za-z/ ]* summary: |^ *'struct rc_\w+' changed:$|^ *type size changed from [0-9]+ to [0-9]+ \(in bits\)$"
grown+="|^ *[0-9]+ data member insertions?:$|^ *'[^']*', at offset [0-9]+ \(in bits\)$"

for state in then now; do
  (cd "$scratch/$state/include/roughcontact" && python3 "$here/interface.py" ./*.h >"$scratch/interface.c")
  "$cc" -w -g -fPIC -shared -Wl,-soname,interface "$scratch/interface.c" -o "$scratch/$state.so"
done
status=0
abidiff --leaf-changes-only --no-added-syms --no-show-locs "$scratch/then.so" "$scratch/now.so" >"$scratch/report" || status=$?
cat "$scratch/report"
if [ $((status & 11)) != 0 ] || grep -qvE "$grown" "$scratch/report"; then
  echo "not compatible with $tag, see docs/compatibility.md"
  exit 1
fi
echo "as $tag, or more"
