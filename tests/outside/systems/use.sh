#!/usr/bin/env bash
# use.sh SYSTEM INSTALLED ANSWERS BACKEND...: uses what is INSTALLED for another system, a folder or an archive of one, as a program of that
# system does, from a folder that has spaces and letters of other alphabets in its name, under the system's emulator: answers with these
# backends, compared with those of this machine in the file ANSWERS; where they are there, the Fortran modules, the command, and a program
# by Microsoft's rules.
set -euo pipefail
system=$1 installed=$(realpath "$2") here_answers=$(realpath "$3")
shift 3
here=$(dirname "$(realpath "$0")")
tree=$(realpath "$here/../../..")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }

cc='' fc='' host='' emulator=''
eval "$(cmake -DTOOLCHAIN="$tree/packaging/cross/$system.cmake" -P "$tree/packaging/cross/parts/describe.cmake")"
IFS=';' read -ra run <<<"$emulator"
root="$scratch/größe λ 1"
cd "$scratch"
if [ -d "$installed" ]; then
  cp -r "$installed" "$root"
else
  mkdir archive
  (cd archive && cmake -E tar xf "$installed")
  mv archive/* "$root"
fi
mkdir -p "$root/bin"
! grep -rlF "$tree" "$root" || fail "these files name a folder of the build"
export LD_LIBRARY_PATH=$root/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH} PKG_CONFIG_LIBDIR=$root/lib/pkgconfig
ln -s "$root" plain  # compilers split what pkg-config says at spaces
flags() { PKG_CONFIG_LIBDIR=$scratch/plain/lib/pkgconfig pkg-config "$@"; }

read -ra contact <<<"$(flags --cflags --libs roughcontact)"
$cc -std=c99 -O2 -Wall -Wextra -Werror "$here/answers.c" -o "$root/bin/answers" "${contact[@]}" -lm
program() { [ -e "$root/bin/$1.exe" ] && echo "$root/bin/$1.exe" || echo "$root/bin/$1"; }
"${run[@]}" "$(program answers)" there.txt "$@" || fail "answers ended with $?"
"$here/compare.py" "$here_answers" there.txt

if command -v "$fc" >/dev/null && [ -e "$root/share/roughcontact/fortran" ]; then
  read -ra modules <<<"$(flags --variable=fortran_source roughcontact-fortran)"
  $fc -O2 -J. "${modules[@]}" "$tree/examples/press_sphere.f90" -o "$root/bin/fortran" "${contact[@]}"
  # Where the compiler's own libraries are, of which this program has no copy.
  WINEPATH="Z:$(dirname "$($fc -print-file-name=libgfortran.a)");Z:/usr/$host/lib" "${run[@]}" "$(program fortran)" >said.txt || fail "Fortran ended with $?"
  grep RC_OK said.txt || fail "Fortran: $(cat said.txt)"
fi

# A command that loads no plugins says so: of those that it is shown, of one that it is asked for, and of itself.
static_command() {
  RC_PLUGIN_PATH=$plugins command backends >said.txt 2>warned.txt || fail "backends ended with $?"
  grep -q "rcb_split.so is not loaded: this program is linked statically" warned.txt || fail "a static command says of a plugin: $(cat warned.txt)"
  grep "is linked statically and loads no plugins" warned.txt || fail "a static command says of itself: $(cat warned.txt)"
  ! grep -q "^split" said.txt || fail "a static command lists split"
  code=0
  command solve 'größe 2.gsf' --E 1GPa --nu 0.3 --pressure 1MPa --backend split 2>warned.txt || code=$?
  [ $code = 1 ] && grep "loads no plugins" warned.txt || fail "a static command, asked for split, ends with $code: $(cat warned.txt)"
  command --version | grep "loads no plugins" || fail "--version: $(command --version)"
}

if [ -f "$(program roughcontact)" ]; then
  command() { "${run[@]}" "$(program roughcontact)" "$@"; }
  command generate spectral --output 'größe 2.gsf' --size 32 --pitch 1um --rms-height 100nm --seed 3 || fail "generate ended with $?"
  command solve 'größe 2.gsf' --E 1GPa --nu 0.3 --pressure 1MPa --out 'out λ' >said.txt || fail "solve ended with $?"
  grep -q RC_OK said.txt || fail "solve: $(cat said.txt)"
  cat 'out λ'/*.json 'out λ'/*.csv >written.txt || fail "solve has written $(ls 'out λ')"
  ! grep -q $'\r' written.txt said.txt || fail "lines end with a carriage return"
  echo "command: $(tail -1 said.txt)"
  plugins=$(echo "$root"/*/roughcontact/abi-*)
  if LC_ALL=C readelf -lW "$(program roughcontact)" 2>/dev/null | grep -q GNU_STACK && ! readelf -lW "$(program roughcontact)" | grep -q INTERP; then
    static_command
  else
    command backends >said.txt || fail "backends ended with $?"
    grep -qE "^split .*rcb_split" said.txt || fail "the command does not load split: $(cat said.txt)"
  fi
fi
[ ! -e "$root/lib/roughcontact.lib" ] || "$here/microsoft.sh" "$scratch/plain" "${run[@]}"
