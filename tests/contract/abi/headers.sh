#!/usr/bin/env bash
# headers.sh INCLUDE_DIR: each public header compiles alone, without a warning and without a hole in any struct, in every
# language and compiler at hand; so do the golden numbers and every RC_..._INIT macro. Lines are no longer than 132 characters.
set -euo pipefail
include=$1
here=$(cd "$(dirname "$0")" && pwd)
warnings=(-Wall -Wextra -pedantic -Wpadded -Wshadow -Werror -fsyntax-only "-I$include")
tried=0
! grep -nE '^.{133}' "$include"/roughcontact/* || { echo 'these lines are too long'; exit 1; }
macros=$(grep -hoE 'RC_[A-Z_]+_INIT' "$include"/roughcontact/*.h | sort -u)
begin() {  # a program that begins one struct of each kind
  printf '#include <roughcontact/%s.h>\n' history derivatives direct product analysis law ranks registry plugin surface formats flow request budget
  for macro in $macros; do local type=${macro%_INIT}; echo "size_t begin_${type,,}(void); size_t begin_${type,,}(void) { ${type,,} x = $macro; return x.struct_size; }"; done
}
for compiler in gcc clang x86_64-w64-mingw32-gcc-posix; do
  command -v $compiler >/dev/null || { echo "$compiler: not installed, left out"; continue; }
  for mode in "c c99" "c c11" "c c17" "c++ c++17" "c++ c++20"; do
    read -r language standard <<<"$mode"
    for header in "$include"/roughcontact/*.h; do
      [ "$(basename "$header")" != mpi.h ] || continue  # needs the header of MPI; the programs of tests/behaviour/ranks compile it
      echo "#include <roughcontact/$(basename "$header")>" | $compiler "${warnings[@]}" -x "$language" -std="$standard" -
    done
    begin | $compiler "${warnings[@]}" -x "$language" -std="$standard" -
    "$here"/golden.py | $compiler "${warnings[@]}" "-I$here" -x "$language" -std="$standard" -
    [ "$standard" != c++20 ] ||
      echo "#include <roughcontact/plugin.hpp>" | $compiler -Wall -Wextra -pedantic -Wshadow -Werror -fsyntax-only "-I$include" -x c++ -std="$standard" -
    echo "$compiler $standard: ok"
    tried=$((tried + 1))
  done
done
[ $tried -gt 0 ]
