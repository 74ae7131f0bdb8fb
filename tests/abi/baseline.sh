#!/usr/bin/env bash
# baseline.sh SOURCE CC --compare | --update | --self-test: compares the binary interface of the public headers (functions,
# argument types, layouts) with the recorded one in baseline/, by libabigail. Additions pass; what would break a program does
# not. Exit code 77 without libabigail. --update records today's. --self-test: deliberate changes of the headers must be told
# apart.
set -euo pipefail
source=$1 cc=$2 mode=$3
here=$(cd "$(dirname "$0")" && pwd)
for tool in abidw abidiff; do
  command -v $tool >/dev/null || { echo "skipped: $tool (Debian: abigail-tools) is not installed"; exit 77; }
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# library NAME INCLUDE HEADER...: $scratch/libNAME.so, the interface that these headers declare. A path of its own for headers,
# always the same, so that it does not differ where nothing else does.
library() {
  local name=$1 include=$2
  shift 2
  rm -rf "$scratch/roughcontact"
  cp -r "$include/roughcontact" "$scratch/roughcontact"
  (cd "$scratch" && python3 "$here/interface.py" "${@/#/roughcontact/}" >"$name.c" &&
    "$cc" -w -g -O0 -fPIC -shared -fdebug-prefix-map="$scratch"=. "-Wl,-soname,lib$name.so.$abi" "$name.c" -o "lib$name.so")
}
libraries() {  # libraries INCLUDE
  abi=$(sed -nE 's/^#define RC_ABI ([0-9]+).*/\1/p' "$1/roughcontact/roughcontact.h")
  library roughcontact "$1" roughcontact.h plugin.h
  library roughcontact-surface "$1" surface.h
}

# compare NAME: of what differs, only these lines may be there: a struct has grown, and every new member lies behind all others
# (one in between would move those after it, which is another line). libabigail's own rules for suppressing reports let more
# pass.
compare() {
  local status=0
  abidiff --leaf-changes-only --no-added-syms "$here/baseline/$1.abi" "$scratch/lib$1.so" >"$scratch/report" || status=$?
  [ $((status & 3)) = 0 ] || { cat "$scratch/report"; echo "abidiff itself failed: $status"; exit 1; }
  [ $((status & 8)) = 0 ] && ! grep -vE "$allowed" "$scratch/report"
}
allowed="^$|^[A-Z][A-Za-z/ ]* summary: |^ *'struct rc_\w+' changed:$|^ *type size changed from [0-9]+ to [0-9]+ \(in bits\)$"
allowed+="|^ *[0-9]+ data member insertions?:$|^ *'[^']*', at offset [0-9]+ \(in bits\)( at .*)?$"

libraries "$source/include"
if [ "$mode" = --update ]; then
  for name in roughcontact roughcontact-surface; do
    abidw --no-comp-dir-path --no-corpus-path --no-show-locs "$scratch/lib$name.so" --out-file "$scratch/$name.abi"
    mv "$scratch/$name.abi" "$here/baseline/$name.abi"
  done
elif [ "$mode" = --self-test ]; then
  change() {  # change pass|break NAME HEADER WHAT SED-EXPRESSION
    rm -rf "$scratch/changed"
    cp -r "$source/include" "$scratch/changed"
    sed -i -E "$5" "$scratch/changed/roughcontact/$3"
    cmp -s {"$source/include","$scratch/changed"}/roughcontact/"$3" && { echo "$4: $3 is not as this test expects"; exit 1; }
    libraries "$scratch/changed"
    local verdict=pass
    compare "$2" >/dev/null || verdict=break
    [ $verdict = "$1" ] || { cat "$scratch/report"; echo "$4: should $1"; exit 1; }
    echo "$1: $4"
  }
  change pass roughcontact roughcontact.h "function added" 's/^(RC_API void rc_contact_destroy.*)/\1\nRC_API void rc_new(rc_contact *contact);/'
  change pass roughcontact roughcontact.h "member appended" 's/^\} rc_result;/  double more;\n} rc_result;/'
  change pass roughcontact plugin.h "function appended to a table" 's/^\} rc_backend;/  rc_status (*more)(void *self);\n} rc_backend;/'
  change break roughcontact roughcontact.h "function removed" '/^RC_API void rc_contact_cancel/d'
  change break roughcontact roughcontact.h "argument widened" 's/rc_contact_level\(rc_contact \*contact, int64_t i/rc_contact_level(rc_contact *contact, int32_t i/'
  change break roughcontact roughcontact.h "member removed" '/^  double energy;  /d'
  change break roughcontact roughcontact.h "member retyped, of the same size" 's/^  int64_t contacts;  /  double contacts;  /'
  change break roughcontact roughcontact.h "member inserted" 's/^(  double load;  .*)/  double before;\n\1/'
  change break roughcontact roughcontact.h "member retyped" 's/^  int32_t control;     /  double control;      /'
  change break roughcontact plugin.h "function's arguments in a table" 's/\(\*apply\)\(void \*self, const double \*x/(*apply)(void *self, const float *x/'
  change break roughcontact-surface surface.h "surface: member inserted" 's/^(typedef struct rc_surface_map \{)/\1\n  int64_t before;/'
else
  for name in roughcontact roughcontact-surface; do
    if compare $name; then
      echo "lib$name: as recorded, or more"
    else
      cat "$scratch/report"
      echo "the interface of lib$name is not what $here/baseline/$name.abi records; see docs/compatibility.md"
      exit 1
    fi
  done
fi
