#!/usr/bin/env bash
# flang.sh FLANG SOURCE LIBDIR MODULE...: compiles the modules, the examples and the tests with flang, and runs them.
set -euo pipefail
flang=$1 source=$2 libdir=$3
shift 3
[ -x "$flang" ] || { echo "skipped: flang is not installed (Debian: flang-19)"; exit 77; }
if "$flang" --version | grep -qE 'version 1[0-7]\.'; then echo "skipped: flang before 18 cannot pass structs by value"; exit 77; fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

fail() { echo "FAILED: $*" >&2; exit 1; }
objects=()
compile() {
  "$flang" -c "$1" -o "$(basename "$1").o"
  objects+=("$(basename "$1").o")
}

for module in "$@"; do compile "$source/bindings/fortran/$module"; done
compile "$source/tests/outside/fortran/checks.f90"
for program in "$source"/examples/*.f90 "$source"/examples/*.f "$source"/tests/outside/fortran/test_*.f90; do
  "$flang" -c "$program" -o program.o
  "$flang" -o program program.o "${objects[@]}" -L"$libdir" "-Wl,-rpath,$libdir" \
    -lroughcontact-surface -lroughcontact-formats -lroughcontact
  ./program >log 2>&1 || { cat log; fail "$program"; }
  echo "$(basename "$program"): $(tail -1 log)"
done
