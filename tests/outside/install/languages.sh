#!/usr/bin/env bash
# languages.sh SOURCE BUILD CC CXX FC: CMake projects of one language alone find what they can use, and get a message of what they cannot.
set -euo pipefail
source=$1 build=$2 cc=$3 cxx=$4 fc=$5
. "$(dirname "$0")/scratch.sh"
install_to "$scratch/prefix"

# configure LANGUAGE COMPONENTS TARGET PROGRAM
configure() {
  rm -rf "$scratch/out"
  clean cmake -S "$source/tests/outside/install/languages" -B "$scratch/out" -DCMAKE_PREFIX_PATH="$scratch/prefix" -DLANGUAGE="$1" \
    -DCOMPONENTS="$2" -DTARGET="$3" -DPROGRAM="$source/examples/$4" -DCMAKE_C_COMPILER="$cc" -DCMAKE_CXX_COMPILER="$cxx" \
    ${fc:+-DCMAKE_Fortran_COMPILER="$fc"} >"$scratch/log" 2>&1
}
works() {
  { configure "$@" && clean cmake --build "$scratch/out" >"$scratch/log" 2>&1; } || { cat "$scratch/log"; fail "$1: $2"; }
  clean "$scratch/out/program" >/dev/null || fail "$1: $2 does not run"
  echo "$1 alone, $2: works"
}
# refused LANGUAGE COMPONENTS TARGET PROGRAM TEXT
refused() {
  configure "${@:1:4}" && fail "$1: $2 is found"
  grep -qF "$5" <(tr -s ' \n' ' ' <"$scratch/log") || { cat "$scratch/log"; fail "$1: $2 gets no message \"$5\""; }
  echo "$1 alone, $2: refused"
}

works C shared roughcontact::roughcontact press_sphere.c
works C '' roughcontact::roughcontact press_sphere.c
grep -q "no static libraries" <(configure C '' roughcontact::roughcontact press_sphere.c; tr -s ' \n' ' ' <"$scratch/log") ||
  fail "C without components gets no message of the static ones"
works 'C;CXX' static roughcontact::static press_sphere.c
refused C static roughcontact::static press_sphere.c \
  'component "static" holds C++ code and needs C++ among the project'"'"'s languages: write project(... LANGUAGES C CXX), or take component "shared"'
refused C surface_static roughcontact::surface_static press_rough.c 'or take component "surface"'
refused C fortran roughcontact::fortran press_sphere.c 'component "fortran" needs Fortran among the project'"'"'s languages'
if [ -n "$fc" ]; then
  works Fortran fortran roughcontact::fortran press_sphere.f90
  refused Fortran 'fortran;static' roughcontact::static press_sphere.f90 'component "static" holds C++ code'
else
  echo "no Fortran compiler: its projects are left out"
fi
