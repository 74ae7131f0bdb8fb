#!/usr/bin/env bash
# wheel.sh SYSTEM [WHEEL GPL-WHEEL]: pip, for that system, installs the wheels (or those that packaging/wheel.sh makes) and NumPy into an
# empty folder, and both are used from there: on aarch64 by Debian's Python for that processor under the emulator, beside musl by a
# Python that is built for it. For Windows there is no Python among Debian's packages: a program in C loads the libraries that were
# installed, under Wine, and solves with every backend, makes a surface and reads one. Exit code 77 without the network or the emulator.
set -euo pipefail
name=$1
here=$(dirname "$(realpath "$0")")
tree=$(realpath "$here/../../..")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
skip() { echo "skipped: $*"; exit 77; }
fail() { echo "FAILED: $*" >&2; exit 1; }
quietly() { "$@" >"$scratch/log" 2>&1 || { tail -40 "$scratch/log"; fail "$*"; }; }
export WINEDEBUG=${WINEDEBUG:--all} WINEPREFIX=${WINEPREFIX:-${XDG_CACHE_HOME:-$HOME/.cache}/roughcontact/wine} CCACHE_BASEDIR=/ CCACHE_NOHASHDIR=1
unset PYTHONPATH ROUGHCONTACT_LIBRARY RC_PLUGIN_PATH

cc='' emulator='' wheel=''
mkdir -p "$tree/build-cross" "${XDG_CACHE_HOME:-$HOME/.cache}/roughcontact"
eval "$(cmake -DTOOLCHAIN="$tree/packaging/cross/$name.cmake" -P "$tree/packaging/cross/parts/describe.cmake")"
IFS=';' read -ra run <<<"$emulator"
command -v "${run[0]}" >/dev/null || skip "${run[0]} is not installed"
command -v "$cc" >/dev/null || skip "$cc is not installed"
dependencies=$(realpath -m "${RC_CROSS_DEPENDENCIES:-$tree/build-cross/dependencies}")
if [ $# -gt 1 ]; then
  files=("$(realpath "$2")" "$(realpath "$3")")
else
  code=0
  "$tree/packaging/wheel.sh" --system "$name" "$scratch/dist" cmake.define.RC_WERROR=ON >"$scratch/made" 2>&1 || code=$?
  [ $code = 0 ] || { tail -40 "$scratch/made"; exit $code; }
  files=("$scratch"/dist/*.whl)
fi
[ ${#files[@]} = 2 ] || fail "there are not two wheels: ${files[*]}"
for file in "${files[@]}"; do
  tag=$(basename "$file" .whl)
  case $name:$tag in aarch64:*-py3-none-manylinux_*_aarch64 | *:*-py3-none-"$wheel") ;; *) fail "$tag is not the name of a wheel for $name" ;; esac
done
cd "$scratch"  # without the tree
pip=(python3 -m pip install -q --target "$scratch/site" --python-version 3.11 --only-binary=:all:)
platforms=()
for file in "${files[@]}"; do
  platform=$(basename "$file" .whl)
  platform=${platform##*-}
  platforms+=(--platform "${platform%%.*}")
done
"${pip[@]}" --no-deps "${platforms[@]}" "${files[@]}" || fail "pip does not install ${files[*]}"
package=$scratch/site/roughcontact
sample=$tree/fuzz/corpus/archive/x3p_valid

if [ "$name" = windows ]; then
  cd "$package/lib"
  "$cc" -std=c99 -O2 -I"$tree/include" "$here/answers.c" -o answers libroughcontact-0.dll
  "$cc" -std=c99 -O2 -I"$tree/include" "$here/surfaces.c" -o surfaces libroughcontact-surface-0.dll libroughcontact-formats-0.dll
  "${run[@]}" answers.exe answers.txt dense fft split || fail "answers ended with $?"
  "${run[@]}" surfaces.exe "$sample" || fail "surfaces ended with $?"
  echo "$tag: $(grep -c '^case' answers.txt) answers, by dense and $(ls roughcontact/abi-* | tr '\n' ' ')"
  exit
fi

if [ "$name" = musl ]; then
  quietly "$here/musl_python.sh" "$dependencies"
  python=("$dependencies/musl/python/bin/python3")
else  # Debian's packages, without a change to this machine's lists of packages
  mkdir -p lists/partial cache/archives/partial root
  : >status
  get=(apt-get -q -o APT::Architecture=arm64 -o APT::Architectures::=arm64 -o Dir::Etc::sourcelist=/etc/apt/sources.list.d/debian.sources
    -o Dir::Etc::sourceparts=/dev/null -o "Dir::State::lists=$PWD/lists" -o "Dir::State::status=$PWD/status"
    -o "Dir::Cache=$PWD/cache" -o APT::Sandbox::User=root -o Debug::NoLocking=1)
  "${get[@]}" update >log 2>&1 || skip "$(tail -1 log)"
  "${get[@]}" install -y --no-install-recommends --download-only python3.11 libstdc++6 >log 2>&1 || skip "$(tail -1 log)"
  for package in cache/archives/*.deb; do
    case $package in */dpkg_* | */tar_*) ;; *) dpkg-deb -x "$package" root ;; esac
  done
  python=(qemu-aarch64 -L "$scratch/root" "$scratch/root/usr/bin/python3.11")
fi
platforms=(--platform manylinux_2_17_aarch64 --platform manylinux_2_28_aarch64)
[ "$name" != musl ] || platforms=(--platform musllinux_1_1_x86_64)  # newer ones have relocations that Debian's musl does not know
"${pip[@]}" "${platforms[@]}" "numpy>=1.21" >log 2>&1 || skip "$(tail -1 log)"
PYTHONPATH=$scratch/site "${python[@]}" -B "$tree/packaging/bare.py" "$sample" dense fft split
echo "$tag: used by $(PYTHONPATH=$scratch/site "${python[@]}" -c 'import sys, sysconfig; print("Python", sys.version.split()[0], sysconfig.get_platform())')"
