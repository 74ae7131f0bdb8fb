#!/usr/bin/env bash
# host.sh SOURCE BUILD CC CXX [build]: another project takes this one by add_subdirectory, FetchContent and find_package, from a folder with
# a space. Its cache, variables, flags, tests and install stay its own, and the targets have the same names. With "build" it also runs.
set -euo pipefail
source=$1 build=$2 cc=$3 cxx=$4 whole=${5:-}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }

library="$scratch/with space/rough contact" host="$scratch/with space/host"
mkdir -p "$library"
(cd "$source" && git ls-files -z 2>/dev/null || find . -path './build*' -prune -o -type f -print0) |
  (cd "$source" && xargs -0 cp --parents -t "$library")
cp -r "$(dirname "$0")/host" "$host"
cmake --install "$build" --prefix "$scratch/with space/prefix" >/dev/null
targets='roughcontact::roughcontact;roughcontact::static;roughcontact::surface;roughcontact::surface_static;roughcontact::formats;roughcontact::formats_static'
components=(-DRC_BUILD_FORMATS=ON -DRC_MODULE_BACKENDS=fft)
# Ours, and what CMake's modules keep of the packages that these components need.
allowed='^(RC_|_?roughcontact_|_?FETCHCONTENT_|__cmake_|(Eigen3|pugixml|GSL|LIBZIP|ZLIB|Threads|PKG_CONFIG|PkgConfig|MPI)(_|$)|pkgcfg_lib_|__pkg_config_|FIND_PACKAGE_MESSAGE_DETAILS_|_CMAKE_Threads_|CMAKE_(HAVE_LIBC_PTHREAD|THREAD_LIBS_INIT|USE_PTHREADS_INIT)=|PTHREAD_|THREADS_FOUND|PACKAGE_PREFIX_DIR|prefix_result=)'

# configure NAME HOW LIBRARY ARGUMENT...: in the folder NAME.
configure() {
  env -u CFLAGS -u CXXFLAGS cmake -S "$host" -B "$scratch/with space/$1" -DHOW="$2" -DLIBRARY="$3" -DCMAKE_C_COMPILER="$cc" \
    -DCMAKE_CXX_COMPILER="$cxx" "${@:4}" >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "$1 cannot be configured"; }
}
# command_of NAME FILE: how FILE is compiled there, whatever the folder.
command_of() {
  python3 - "$scratch/with space/$1" "$2" <<'PYTHON'
import json, sys
folder, file = sys.argv[1:]
commands = [each["command"] for each in json.load(open(folder + "/compile_commands.json")) if file in each["command"]]
print(commands[0].replace(folder, ""))
PYTHON
}
# unchanged NAME PLAIN: nothing of the host's is changed, and its own file is compiled as without this project.
unchanged() {
  local changed
  changed=$(diff "$scratch/with space/$1/before.txt" "$scratch/with space/$1/after.txt" | sed -n 's/^[<>] //p' | grep -vE "$allowed" || true)
  [ -z "$changed" ] || fail "$1 changes the host's $changed"
  grep -q alone.c <<<"$(command_of "$1" alone.c)" && [ "$(command_of "$1" alone.c)" = "$(command_of "$2" alone.c)" ] || fail "$1 changes how the host is compiled: $(command_of "$1" alone.c)"
  echo "$1: unchanged"
}

configure plain '' ''
configure plain-debug '' '' -DCMAKE_BUILD_TYPE=Debug
for how in subdirectory fetch; do
  configure $how $how "$library" -DTARGETS="$targets;roughcontact::fortran" "${components[@]}"
  unchanged $how plain
  grep -q -- -O3 <<<"$(command_of $how rc_objects.dir)" || fail "$how: without a build type the library is not optimised: $(command_of $how rc_objects.dir)"
done
configure subdirectory subdirectory "$library"  # once more
unchanged subdirectory plain
configure debug subdirectory "$library" "${components[@]}" -DCMAKE_BUILD_TYPE=Debug -DBUILD_TESTING=OFF -DCMAKE_LIBRARY_OUTPUT_DIRECTORY="$scratch/with space/out"
unchanged debug plain-debug
! grep -q -- -O3 <<<"$(command_of debug rc_objects.dir)" || fail "the host's build type is not the library's"
configure installed installed "$scratch/with space/prefix" -DTARGETS="$targets"
unchanged installed plain

# The host's install is its own.
cmake --build "$scratch/with space/subdirectory" --target alone >/dev/null
cmake --install "$scratch/with space/subdirectory" --prefix "$scratch/installed" >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "the host cannot be installed"; }
installed=$(cd "$scratch/installed" && find . -type f)
[ "$installed" = ./bin/alone ] || fail "the host's install has $installed"
[ -n "$whole" ] || exit 0

for how in subdirectory installed; do
  cmake --build "$scratch/with space/$how" --target shared static >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "$how does not build"; }
  for program in shared static; do
    plugins=''
    [ $how-$program != installed-static ] || plugins=$(dirname "$(find "$scratch/with space/prefix" -name rcb_fft.so)")
    RC_PLUGIN_PATH=$plugins "$scratch/with space/$how/$program" || fail "$how, $program: does not run"
  done
done
configure subdirectory subdirectory "$library" -DRC_INSTALL=ON
cmake --build "$scratch/with space/subdirectory" >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "RC_INSTALL=ON does not build"; }
cmake --install "$scratch/with space/subdirectory" --prefix "$scratch/with-library" >/dev/null
[ -n "$(find "$scratch/with-library" -name roughcontactConfig.cmake)" ] || fail "RC_INSTALL=ON does not install the library"
