#!/usr/bin/env bash
# use.sh SYSTEM FOLDER NATIVE BACKEND...: uses what is installed in FOLDER for another system as a program of that system does, from a
# folder that has spaces and letters of other alphabets in its name, under the system's emulator: answers with these backends, compared
# with those of this machine's build in NATIVE; where they are there, the Fortran modules, the command, and a program by Microsoft's rules.
set -euo pipefail
system=$1 folder=$(realpath "$2") native=$(realpath "$3")
shift 3
here=$(dirname "$(realpath "$0")")
tree=$(realpath "$here/../..")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }

cc='' fc='' host='' emulator=''
eval "$(cmake -DTOOLCHAIN="$tree/packaging/cross/$system.cmake" -P "$tree/packaging/cross/parts/describe.cmake")"
IFS=';' read -ra run <<<"$emulator"
root="$scratch/größe λ 1"
cp -r "$folder" "$root"
mkdir -p "$root/bin"
cd "$scratch"
export LD_LIBRARY_PATH=$root/lib PKG_CONFIG_LIBDIR=$root/lib/pkgconfig
ln -s "$root" plain  # compilers split what pkg-config says at spaces
flags() { PKG_CONFIG_LIBDIR=$scratch/plain/lib/pkgconfig pkg-config "$@"; }

read -ra contact <<<"$(flags --cflags --libs roughcontact)"
$cc -std=c99 -O2 -Wall -Wextra -Werror "$here/answers.c" -o "$root/bin/answers" "${contact[@]}"
program() { [ -e "$root/bin/$1.exe" ] && echo "$root/bin/$1.exe" || echo "$root/bin/$1"; }
"${run[@]}" "$(program answers)" there.txt "$@" || fail "answers ended with $?"
cc -std=c99 -O2 -I"$tree/include" "$here/answers.c" -o answers-here -L"$native/lib" -lroughcontact
LD_LIBRARY_PATH=$native/lib ./answers-here here.txt "$@"
"$here/compare.py" here.txt there.txt

if command -v "$fc" >/dev/null && [ -e "$root/share/roughcontact/fortran" ]; then
  read -ra modules <<<"$(flags --variable=fortran_source roughcontact-fortran)"
  $fc -O2 -J. "${modules[@]}" "$tree/examples/press_sphere.f90" -o "$root/bin/fortran" "${contact[@]}"
  # Where the compiler's own libraries are, of which this program has no copy.
  own=$(dirname "$(realpath "$($fc -print-file-name=libgfortran.so)")")
  LD_LIBRARY_PATH=$LD_LIBRARY_PATH:$own WINEPATH="Z:$(dirname "$($fc -print-file-name=libgfortran.a)");Z:/usr/$host/lib" "${run[@]}" "$(program fortran)" >said.txt || fail "Fortran ended with $?"
  grep RC_OK said.txt || fail "Fortran: $(cat said.txt)"
fi

if [ -f "$(program roughcontact)" ]; then
  command() { "${run[@]}" "$(program roughcontact)" "$@"; }
  command generate spectral --output 'größe 2.gsf' --size 32 --pitch 1um --rms-height 100nm --seed 3 || fail "generate ended with $?"
  command solve 'größe 2.gsf' --E 1GPa --nu 0.3 --pressure 1MPa --out 'out λ' >said.txt || fail "solve ended with $?"
  grep -q RC_OK said.txt || fail "solve: $(cat said.txt)"
  cat 'out λ'/*.json 'out λ'/*.csv >written.txt || fail "solve has written $(ls 'out λ')"
  ! grep -q $'\r' written.txt said.txt || fail "lines end with a carriage return"
  echo "command: $(tail -1 said.txt)"
fi
[ ! -e "$root/lib/roughcontact.lib" ] || "$here/microsoft.sh" "$scratch/plain" "${run[@]}"
