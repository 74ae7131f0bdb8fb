#!/usr/bin/env bash
# wheel.sh SYSTEM WHEEL: pip, told of that system, installs the wheel and NumPy into an empty folder, and it is used from there: on
# aarch64 by Debian's Python for that processor, under the emulator. For Windows and musl there is no Python that could be had here: a
# program in C loads the library that was installed and solves with every backend. Exit code 77 without the network.
set -euo pipefail
name=$1 file=$(realpath "$2")
here=$(dirname "$(realpath "$0")")
tree=$(realpath "$here/../..")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
skip() { echo "skipped: $*"; exit 77; }
fail() { echo "FAILED: $*" >&2; exit 1; }

cc='' emulator=''
eval "$(cmake -DTOOLCHAIN="$tree/packaging/cross/$name.cmake" -P "$tree/packaging/cross/parts/describe.cmake")"
IFS=';' read -ra run <<<"$emulator"
tag=$(basename "$file" .whl)
pip=(python3 -m pip install -q --target "$scratch/site" --python-version 3.11 --only-binary=:all:)
"${pip[@]}" --no-deps --platform "${tag##*-}" "$file" || fail "pip does not install $file"
package=$scratch/site/roughcontact

if [ "$name" != aarch64 ]; then
  cd "$package/lib"
  $cc -std=c99 -O2 -I"$tree/include" "$here/answers.c" -o answers "$(ls libroughcontact.so.0 libroughcontact-0.dll 2>/dev/null)"
  LD_LIBRARY_PATH=$PWD "${run[@]}" "$(ls answers answers.exe 2>/dev/null)" answers.txt dense fft split || fail "it ended with $?"
  echo "$name: the library in the wheel gives $(grep -c '^case' answers.txt) answers, by $(ls roughcontact/abi-* | tr '\n' ' ')"
  exit
fi

# Python of that processor: Debian's packages, without a change to this machine's lists of packages.
mkdir -p "$scratch/lists/partial" "$scratch/cache/archives/partial" "$scratch/root"
: >"$scratch/status"
get=(apt-get -q -o APT::Architecture=arm64 -o APT::Architectures::=arm64 -o Dir::Etc::sourcelist=/etc/apt/sources.list.d/debian.sources
  -o Dir::Etc::sourceparts=/dev/null -o "Dir::State::lists=$scratch/lists" -o "Dir::State::status=$scratch/status"
  -o "Dir::Cache=$scratch/cache" -o APT::Sandbox::User=root -o Debug::NoLocking=1)
"${get[@]}" update >"$scratch/log" 2>&1 || skip "$(tail -1 "$scratch/log")"
"${get[@]}" install -y --no-install-recommends --download-only python3.11 libstdc++6 >"$scratch/log" 2>&1 || skip "$(tail -1 "$scratch/log")"
for package in "$scratch"/cache/archives/*.deb; do
  case $package in */dpkg_* | */tar_*) ;; *) dpkg-deb -x "$package" "$scratch/root" ;; esac
done
"${pip[@]}" --platform manylinux_2_17_aarch64 --platform manylinux_2_28_aarch64 "numpy>=1.21" >"$scratch/log" 2>&1 || skip "$(tail -1 "$scratch/log")"
PYTHONPATH=$scratch/site qemu-aarch64 -L "$scratch/root" "$scratch/root/usr/bin/python3.11" -B "$tree/packaging/bare.py" \
  "$tree/fuzz/corpus/archive/x3p_valid" dense fft split
