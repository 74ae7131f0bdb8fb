#!/usr/bin/env bash
# symbols.sh INCLUDE_DIR LIBRARY: the library exports what the headers declare and golden.txt lists, nothing else, and its
# SONAME and the version of every symbol carry the ABI number.
set -euo pipefail
include=$1 library=$2
golden=$(mktemp)
trap 'rm -f "$golden"' EXIT
sed "1,/^# functions/d" "$(dirname "$0")/golden.txt" | tr -s " " "\n" | grep . >"$golden"
declared() {  # functions marked RC_API but those of libroughcontact-surface, -formats, -flow, -request (budgets included) and -mpi
  grep -h '^RC_API ' "$include"/roughcontact/*.h | grep -v 'rc_surface_\|rc_flow_\|rc_mpi_\|rc_request_\|rc_word_\|rc_budget_' | sed -E 's/^RC_API [^(]*\b(rc_[a-z_]+)\(.*/\1/' | LC_ALL=C sort
}
exported() { nm -D --defined-only "$library" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' | LC_ALL=C sort; }
diff -u "$golden" <(declared) || { echo "golden.txt and the headers differ"; exit 1; }
diff -u "$golden" <(exported) || { echo "golden.txt and the exports of $library differ"; exit 1; }
abi=$(sed -nE 's/^#define RC_ABI ([0-9]+).*/\1/p' "$include/roughcontact/roughcontact.h")
readelf -d "$library" | grep -F "SONAME" | grep -F "[libroughcontact.so.$abi]"
! nm -D --defined-only "$library" | awk '$2 != "A" { print $3 }' | grep -v "@@ROUGHCONTACT_$abi\$" || { echo "symbols of no version"; exit 1; }
echo "$(wc -l <"$golden") symbols"
