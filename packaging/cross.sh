#!/usr/bin/env bash
# packaging/cross.sh [--smoke | --test] SYSTEM... | all: builds for other systems on this machine. SYSTEM: a file SYSTEM.cmake of
# packaging/cross. Into build-cross: SYSTEM-root, a folder that can be moved, and an archive of it, roughcontact-VERSION-SYSTEM.zip or
# .tar.xz.
#   --test   builds the tests, too, and runs the quick ones where the system's emulator is installed
#   --smoke  instead of all that: the library, the backends dense and fft and the comparison with this machine's answers; where nothing
#            runs it, src/platform is compiled
# Libraries that it links go into RC_CROSS_DEPENDENCIES (build-cross/dependencies if it is not set), once.
set -euo pipefail
what=''
case ${1:-} in --smoke | --test) what=$1; shift ;; esac
[ $# -gt 0 ] || { sed -n '2,8s/^# //p' "$0"; exit 2; }
tree=$(cd "$(dirname "$0")/.." && pwd)
cd "$tree"
# i686 is no system of packages: it is built for its 32 bits.
[ "$*" != all ] || set -- $(cd packaging/cross && printf '%s\n' *.cmake | sed 's/\.cmake$//' | grep -vx i686)
dependencies=$(realpath -m "${RC_CROSS_DEPENDENCIES:-build-cross/dependencies}")
version=$(sed -nE 's/^project\(roughcontact VERSION ([0-9.]+).*/\1/p' CMakeLists.txt)
# Wine's folder lies outside of the tree: it has a link to /, which what walks the tree to make an archive would follow.
mkdir -p build-cross "${XDG_CACHE_HOME:-$HOME/.cache}/roughcontact"
export LC_ALL=C.UTF-8 WINEDEBUG=${WINEDEBUG:--all} WINEPREFIX=${WINEPREFIX:-${XDG_CACHE_HOME:-$HOME/.cache}/roughcontact/wine}

# quietly LOG COMMAND...
quietly() {
  "${@:2}" >"$1" 2>&1 || { grep -E -m 20 'error|Error' "$1" || tail -20 "$1"; echo "failed: ${*:2:3} ...; see $1"; return 1; }
}

# configure SYSTEM FOLDER OPTION...
configure() (
  export PKG_CONFIG_LIBDIR=$dependencies/$1/lib/pkgconfig LDFLAGS=-L$dependencies/$1/lib
  quietly "$2.log" cmake -S . -B "$2" -DCMAKE_TOOLCHAIN_FILE="$tree/packaging/cross/$1.cmake" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_FIND_ROOT_PATH="$dependencies/$1" -DCMAKE_INSTALL_PREFIX=/roughcontact -DCMAKE_INSTALL_LIBDIR=lib -DRC_WERROR=ON -DRC_BUILD_BENCH=OFF \
    -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 "${@:3}"
)

# answer_here FILE BACKEND...: this machine's answers, once for all systems.
answer_here() (
  native=build-cross/native
  exec 8>build-cross/answers.lock
  flock 8
  if [ -e build-gcc/lib/roughcontact/abi-1/rcb_fft.so ]; then
    native=build-gcc
  else
    quietly $native.log cmake -S . -B $native -DCMAKE_BUILD_TYPE=Release "${core[@]}" "-DRC_MODULE_BACKENDS=fft;split"
    quietly $native.log cmake --build $native -j "$(nproc)"
  fi
  [ "$1" -nt $native/lib/libroughcontact.so ] && [ "$1" -nt tests/outside/systems/answers.c ] && return
  cc -std=c99 -O2 -Iinclude tests/outside/systems/answers.c -o build-cross/answers -L$native/lib -lroughcontact -lm
  LD_LIBRARY_PATH=$native/lib build-cross/answers "$1.new" "${@:2}"
  mv "$1.new" "$1"
)

# use SYSTEM INSTALLED BACKEND...: a folder or an archive, as a program of that system uses it; 77 where the emulator is missing.
use() {
  local program=${emulator%%;*} answers="build-cross/answers by ${*:3}.txt"
  [ -n "$program" ] || { echo "$1: built; nothing runs it here"; return 0; }
  command -v "$program" >/dev/null || { echo "$1: built, not run: $program is not installed"; return 77; }
  answer_here "$answers" "${@:3}" || return
  # Wine's services outlive a program by seconds and keep the pipes open that they were started with. This program, which ends with this
  # shell, holds them for all others.
  [ "$system" != Windows ] || exec {services}> >(exec "$program" cmd /c 'set /p end=' >/dev/null 2>&1)
  # Fortran's run-time libraries, without the C library in their folder: another one than that of the loader that runs programs here.
  if [ "$emulator" = env ] && [ -n "$fc" ]; then
    export LD_LIBRARY_PATH=$tree/build-cross/$1-fortran
    mkdir -p "$LD_LIBRARY_PATH"
    for name in libgfortran.so.5 libquadmath.so.0 libgcc_s.so.1; do
      ln -sf "$(realpath "$("$fc" -print-file-name=$name)")" "$LD_LIBRARY_PATH/$name"
    done
  fi
  tests/outside/systems/use.sh "$1" "$2" "$answers" "${@:3}"
}

smoke() {
  # These options take least time to compile and to run; GNU's compilers seldom look for memory to use again.
  local build=build-cross/$1-smoke level='-Og --param ggc-min-expand=400 --param ggc-min-heapsize=1000000' targets=()
  [[ $cc != */zig/* ]] || level=-O0
  local kind=("-DCMAKE_CXX_FLAGS_RELEASE=$level -DNDEBUG")
  # Where nothing runs, only what differs between systems, and nothing is linked: zig would build its C++ library for that.
  [ -n "$emulator" ] || kind+=(-DCMAKE_CXX_FLAGS=-c -DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY) \
    targets=(--target rc_platform_files rc_platform_libraries rc_platform_memory rc_platform_process rc_platform_terminal)
  configure "$1" "$build" "${core[@]}" "${kind[@]}"
  quietly "$build.log" cmake --build "$build" "${targets[@]}"
  [ -n "$emulator" ] || { echo "src/platform compiled; nothing runs it here"; return; }
  rm -rf "$build-root"
  quietly "$build.log" cmake --install "$build" --prefix "$build-root"
  use "$1" "$build-root" dense fft
}

everything() {
  local build=build-cross/$1 name=roughcontact-$version-$1 form=(-cJf) suffix=tar.xz tests=OFF kind=("-DRC_MODULE_BACKENDS=fft;split")
  local c_library=()  # where it is linked in
  [ "$system" != Windows ] || form=(-cf --format=zip) suffix=zip c_library=(/usr/share/doc/mingw-w64-common/copyright)
  [ "$what" != --test ] || [ -z "$emulator" ] || tests=ON
  # The command of musl runs wherever there is Linux; it has dense and fft inside.
  [ "$1" != musl ] || kind=("-DRC_BUILTIN_BACKENDS=dense;fft" -DRC_MODULE_BACKENDS=split -DRC_STATIC_COMMAND=ON) \
    c_library=(/usr/share/doc/musl/copyright)
  quietly "build-cross/$1-dependencies.log" packaging/cross/dependencies.sh "$1" "$dependencies"
  configure "$1" "$build" -DRC_BUILD_TESTS=$tests -DRC_BUILD_EXAMPLES=$tests "${kind[@]}" -DRC_WRITE_NETCDF=OFF
  quietly "$build.log" cmake --build "$build" -j "$(nproc)"
  rm -rf "$build-root"
  quietly "$build.log" cmake --install "$build" --strip --prefix "$build-root/$name"
  cp LICENSE "$build-root/$name"
  cat packaging/notices/{head,eigen,fftw,gsl,cli11,json} /usr/share/doc/{libpugixml-dev,libzip-dev,zlib1g-dev}/copyright "${c_library[@]}" \
    >"$build-root/$name/NOTICES"
  (cd "$build-root" && cmake -E tar "${form[0]}" "../$name.$suffix" "${form[@]:1}" "$name")
  echo "$1: build-cross/$name.$suffix, $(du -h "build-cross/$name.$suffix" | cut -f1)"
  [ $tests = ON ] || return 0
  use "$1" "build-cross/$name.$suffix" dense fft split || return
  RC_TEST_QUICK=1 ctest --test-dir "$build" --output-on-failure --no-tests=error --timeout 600 \
    -LE 'slow|full' -j "$(nproc)"
}

core=(-DRC_BUILD_SURFACE=OFF -DRC_BUILD_FORMATS=OFF -DRC_BUILD_TOOLS=OFF -DRC_BUILD_TESTS=OFF -DRC_BUILD_EXAMPLES=OFF -DRC_BUILD_BENCH=OFF
  -DRC_MODULE_BACKENDS=fft)
if [ $# = 1 ]; then
  [ -e "packaging/cross/$1.cmake" ] || { echo "packaging/cross has no $1.cmake"; exit 2; }
  eval "$(cmake -DTOOLCHAIN="$tree/packaging/cross/$1.cmake" -P packaging/cross/parts/describe.cmake)"
  if [ "$what" = --smoke ]; then smoke "$1"; else everything "$1"; fi
  exit
fi
result=0 runs=()
# Smoke tests side by side: most of each is one compilation.
[ "$what" != --smoke ] || for name in "$@"; do
  packaging/cross.sh --smoke "$name" >"build-cross/$name-said" 2>&1 &
  runs+=($!)
done
for name in "$@"; do
  code=0
  if [ "$what" = --smoke ]; then
    wait "${runs[0]}" || code=$?
    runs=("${runs[@]:1}")
    sed "s/^/$name: /" "build-cross/$name-said"
  else
    packaging/cross.sh $what "$name" || code=$?
  fi
  [ $code = 0 ] || [ $code = 77 ] || echo "$name: failed"
  case $code in 0) ;; 77) [ $result != 0 ] || result=77 ;; *) result=1 ;; esac
done
exit $result
