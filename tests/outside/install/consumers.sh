#!/usr/bin/env bash
# consumers.sh SOURCE BUILD CC CXX FC BACKEND...: installs to a scratch prefix and uses it from there as strangers would, in C,
# C++, Fortran (FC "" leaves it out) and CMake, shared and static, on every backend; then moves the prefix and does it again.
set -euo pipefail
source=$1 build=$2 cc=$3 cxx=$4 fc=$5
shift 5
backends=("$@")
. "$(dirname "$0")/scratch.sh"
[ -n "$fc" ] || echo "no Fortran compiler: its consumers are left out"

# expect NAME PROGRAM...: the program solves on every backend and finds Hertz's load within 3 %, and refuses an unknown name.
expect() {
  local name=$1 line backend
  shift
  for backend in "${backends[@]}"; do
    line=$(clean "$@" "$backend") || fail "$name on $backend"
    echo "$name: $line"
    [[ $line == *" on $backend: load "*RC_OK* ]] || fail "$name did not certify on $backend"
    awk '{ for (i = 1; i < NF; ++i) if ($i == "load") exit !(($(i + 1) / 30.6667 - 1) ^ 2 < 0.03 ^ 2) }' <<<"$line" || fail "$name: load"
  done
  line=$(clean "$@" no-such-backend 2>&1) && fail "$name accepted an unknown backend"
  [[ $line == *RC_ERR_NO_BACKEND* ]] || fail "$name: unknown backend gave: $line"
}

# expect_read NAME PROGRAM...: the program reads a small map and says what it took for granted.
expect_read() {
  local name=$1 line
  shift
  printf '0 1 2\n3 nan 5\n' >"$scratch/map.txt"
  line=$(clean "$@" "$scratch/map.txt" 1e-6) || fail "$name does not read"
  [[ $line == "3 x 2 points, text, pitch 1e-06 m, 1e-06 m, 1 missing; lengths without a unit are in m"* ]] || fail "$name: $line"
  line=$(clean "$@" "$scratch/none" 1e-6 2>&1) && fail "$name reads a file that is not there"
  [[ $line == *"none: No such file"* ]] || fail "$name: $line"
  echo "read $name: ok"
}

build_and_run() {  # build_and_run PREFIX KIND...
  local prefix=$1 kind flags libs modules rpath run
  shift
  find_pc "$prefix"
  pkg --validate roughcontact roughcontact-fortran roughcontact-surface roughcontact-formats roughcontact-request
  [[ $(pkg --variable=libdir roughcontact) -ef $pc/.. ]] || fail "libdir is not where the library is"
  rpath=-Wl,-rpath,$(pkg --variable=libdir roughcontact)
  out=$(mktemp -d "$scratch/out.XXXX")
  for kind in "$@"; do
    read -ra flags <<<"$(pkg --cflags roughcontact)"
    if [ "$kind" = shared ]; then
      read -ra libs <<<"$(pkg --libs roughcontact) $rpath"
      run=(env)
    else
      read -ra libs <<<"$(pkg --variable=static_libs roughcontact)"
      run=(env RC_PLUGIN_PATH="$(pkg --variable=plugindir roughcontact)")
    fi
    clean "$cc" -std=c99 -Wall -Wextra -pedantic -Werror "${flags[@]}" "$source/examples/press_sphere.c" -o "$out/c" "${libs[@]}"
    expect "C $kind" "${run[@]}" "$out/c"
    clean "$cxx" -std=c++17 -Wall -Wextra -pedantic -Werror "${flags[@]}" -x c++ "$source/examples/press_sphere.c" -x none -o "$out/c++" "${libs[@]}"
    expect "C++ $kind" "${run[@]}" "$out/c++"
    if [ -n "$fc" ]; then
      read -ra modules <<<"$(pkg --variable=fortran_source roughcontact-fortran)"
      clean "$fc" -J "$out" "${modules[@]}" "$source/examples/press_sphere.f90" -o "$out/f" "${libs[@]}"
      expect "Fortran $kind" "${run[@]}" "$out/f"
    fi
    # Only a program that makes surfaces links the GNU Scientific Library.
    ! readelf -d "$out/c" | grep -q 'NEEDED.*libgsl' || fail "$kind: the solver's consumer links GSL"
    if [ "$kind" = shared ]; then
      read -ra libs <<<"$(pkg --libs roughcontact roughcontact-surface) $rpath"
    else
      read -ra libs <<<"$(pkg --variable=static_libs roughcontact-surface) $(pkg --variable=static_libs roughcontact)"
    fi
    clean "$cc" -std=c99 -Wall -Wextra -pedantic -Werror "${flags[@]}" "$source/examples/press_rough.c" -o "$out/rough" "${libs[@]}"
    line=$(clean "${run[@]}" "$out/rough") || fail "surfaces $kind"
    [[ $line == *"proven to lie in"*" 0 undecided"* ]] || fail "surfaces $kind: $line"
    echo "surfaces $kind: $(tail -1 <<<"$line")"
    if [ "$kind" = shared ]; then
      read -ra libs <<<"$(pkg --libs roughcontact-formats) $rpath"
    else
      read -ra libs <<<"$(pkg --variable=static_libs roughcontact-formats)"
    fi
    clean "$cc" -std=c99 -Wall -Wextra -pedantic -Werror "${flags[@]}" "$source/examples/read_surface.c" -o "$out/read" "${libs[@]}"
    expect_read "C $kind" "$out/read"
    if [ -n "$fc" ]; then
      read -ra modules <<<"$(pkg --variable=fortran_source roughcontact-fortran) $(pkg --variable=formats_source roughcontact-fortran)"
      if [ "$kind" = static ]; then libs+=("$(pkg --variable=libdir roughcontact)/libroughcontact.a"); else libs+=(-lroughcontact); fi
      read -ra more <<<"$(pkg --variable=private_libs roughcontact)"
      clean "$fc" -J "$out" "${modules[@]}" "$source"/tests/outside/fortran/{checks,test_files}.f90 -o "$out/readf" "${libs[@]}" "${more[@]}"
      (cd "$out" && clean ./readf) || fail "Fortran $kind does not read"
    fi
    # Only a program that reads files links what that needs.
    ! readelf -d "$out/c" | grep -qE 'NEEDED.*lib(zip|pugixml)' || fail "$kind: the solver's consumer links libzip"
    [ "$kind" = shared ] || ! readelf -d "$out/c" | grep -q 'NEEDED.*roughcontact' || fail "the static consumer needs the shared library"
  done

  clean cmake -S "$source/tests/outside/install/cmake" -B "$out/cmake" -DCMAKE_PREFIX_PATH="$prefix" -DEXAMPLES="$source/examples" \
    -DCMAKE_C_COMPILER="$cc" -DCMAKE_CXX_COMPILER="$cxx" \
    -DCMAKE_Fortran_COMPILER="$fc" >"$out/log" 2>&1 || { cat "$out/log"; fail "find_package"; }
  clean cmake --build "$out/cmake" >"$out/log" 2>&1 || { cat "$out/log"; fail "the CMake consumer does not build"; }
  expect "CMake shared" "$out/cmake/shared"
  clean "$out/cmake/rough" >/dev/null || fail "CMake surfaces"
  expect_read "CMake" "$out/cmake/read"
  expect_read "CMake static" "$out/cmake/read_static"
  [ -z "$fc" ] || expect "CMake Fortran" "$out/cmake/fortran"
  expect "CMake static" env RC_PLUGIN_PATH="$(pkg --variable=plugindir roughcontact)" "$out/cmake/static"
}

install_to "$scratch/first"
build_and_run "$scratch/first" shared static
libdir=$(pkg --variable=libdir roughcontact)
"$source/tests/contract/abi/symbols.sh" "$(pkg --variable=includedir roughcontact)" "$libdir/libroughcontact.so"

echo "the same after moving the prefix"
mkdir "$scratch/elsewhere"
mv "$scratch/first" "$scratch/elsewhere/second"
build_and_run "$scratch/elsewhere/second" shared static
echo "all consumers work"
