#!/usr/bin/env bash
# symbols.sh INCLUDE_DIR NAME LIBRARY: the library libroughcontact-NAME exports what its header NAME.h declares, nothing else,
# carries the ABI number in its SONAME, needs no libroughcontact and does not touch GSL's error handler.
set -euo pipefail
include=$1 name=$2 library=$3
declared() { grep '^RC_API ' "$include/roughcontact/$name.h" | sed -E 's/^RC_API [^(]*\b(rc_surface_[a-z_]+)\(.*/\1/' | LC_ALL=C sort; }
exported() { nm -D --defined-only "$library" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' | LC_ALL=C sort; }
diff -u <(declared) <(exported) || { echo "the header and the exports of $library differ"; exit 1; }
abi=$(sed -nE 's/^#define RC_ABI ([0-9]+).*/\1/p' "$include/roughcontact/roughcontact.h")
dynamic=$(readelf -d "$library")
grep -F SONAME <<<"$dynamic" | grep -F "[libroughcontact-$name.so.$abi]"
! grep NEEDED <<<"$dynamic" | grep -F '[libroughcontact.so' || { echo "$library needs libroughcontact"; exit 1; }
! nm -D -u "$library" | grep -E 'gsl_(set_error_handler|error\b)' || { echo "$library touches GSL's error handler"; exit 1; }
echo "$(declared | wc -l) symbols"
