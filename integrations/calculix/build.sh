#!/bin/sh
# build.sh FOLDER [heat]: CalculiX 2.20 with contact laws of roughcontact, as FOLDER/ccx; heat: unpatched but for the user file gapcon.f.
# Sources and libraries are Debian's packages, fetched with apt into FOLDER and installed nowhere. pkg-config must find roughcontact.
# Exit code 77: a tool or the sources are missing here.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
cd "$1"
folder=$(pwd)
part=${2:-all}
missing() { echo "build.sh: $*" >&2; exit 77; }
for tool in apt-get dpkg-source dpkg-architecture patch make gfortran cc pkg-config; do
  command -v $tool >/dev/null || missing "$tool is not installed"
done
pkg-config --exists roughcontact || missing "pkg-config does not find roughcontact; is PKG_CONFIG_PATH set?"

# The machine's own list of packages, with sources.
private_apt() {
  apt-get -q -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$folder/apt/sources" -o Dir::State::lists="$folder/apt/lists" \
    -o Dir::Cache="$folder/apt/cache" -o APT::Sandbox::User= "$@"
}
fetch() {
  mkdir -p apt/sources apt/lists/partial apt/cache/archives/partial
  for list in /etc/apt/sources.list /etc/apt/sources.list.d/*; do
    [ -e "$list" ] || continue
    case $list in
      *.sources) sed 's/^Types:.*/Types: deb deb-src/' "$list" >"apt/sources/${list##*/}" ;;
      *.list) sed -n 's/^deb[ \t]\(.*\)/deb \1\ndeb-src \1/p' "$list" >"apt/sources/${list##*/}" ;;
    esac
  done
  private_apt update || echo "build.sh: some lists of packages could not be read" >&2
  private_apt download libspooles-dev libarpack2-dev liblapack-dev libblas-dev || missing "the libraries cannot be downloaded"
  for package in *.deb; do
    dpkg-deb -x "$package" libraries
  done
  private_apt source calculix-ccx=2.20-1 || missing "there are no sources of calculix-ccx 2.20-1; other versions need another patch"
  [ "$part" = heat ] || patch -d calculix-ccx-2.20/ccx_2.20 -p1 <"$here/ccx_2.20.patch"
  touch fetched
}
[ -e fetched ] || fetch

sources=$folder/calculix-ccx-2.20/ccx_2.20/src
include=$folder/libraries/usr/include/spooles
lib=$folder/libraries/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)
optimize=${CCX_OPTIMIZE:--O2}
[ "$part" = heat ] && own=gapcon.f || own=roughcontact.f
for file in rough_functions.f "$own"; do  # the second includes the first
  cmp -s "$here/$file" "$sources/$file" || cp "$here/rough_functions.f" "$here/$own" "$sources"
done
make -C "$sources" -j "$(nproc)" CC=cc FC=gfortran FFLAGS="$optimize -w -fopenmp -fallow-argument-mismatch" \
  CFLAGS="$optimize -w -fopenmp -I$include -DARCH=Linux -DSPOOLES -DARPACK -DMATRIXSTORAGE -DUSE_MT=1" ccx_2.20.o ccx_2.20.a >make.log 2>&1 ||
  { tail -n 20 make.log >&2; exit 1; }
# Static libraries: ccx runs wherever libroughcontact stays.
gfortran -fopenmp -o ccx "$sources/ccx_2.20.o" "$sources/ccx_2.20.a" "$lib/libspooles.a" "$lib/libarpack.a" "$lib/lapack/liblapack.a" \
  "$lib/blas/libblas.a" $(pkg-config --libs roughcontact) -Wl,-rpath,"$(pkg-config --variable=libdir roughcontact)" -lpthread -lm
echo "$folder/ccx"
