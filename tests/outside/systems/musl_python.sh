#!/usr/bin/env bash
# musl_python.sh DEPENDENCIES: CPython for musl in DEPENDENCIES/musl/python, from Debian's source packages, for tests of the wheel: Debian has no
# Python beside musl. What is there is not built again. Minutes.
set -euo pipefail
here=$(dirname "$(realpath "$0")")
cross=$here/../../../packaging/cross
"$cross/dependencies.sh" musl "$1"
prefix=$(realpath "$1")/musl sources=$(realpath "$1")/sources
[ ! -x "$prefix/python/bin/python3" ] || exit 0
"$cross/parts/sources.sh" "$sources" libffi python3.11
cc='' ar='' ranlib='' host=''
eval "$(cmake -DTOOLCHAIN="$cross/musl.cmake" -P "$cross/parts/describe.cmake")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export CC="${CMAKE_C_COMPILER_LAUNCHER:-} $cc" AR=$ar RANLIB=$ranlib CFLAGS="-O1 -fPIC -Wno-date-time" PKG_CONFIG_LIBDIR=$prefix/lib/pkgconfig
jobs=$(nproc)

mkdir "$work/libffi" "$work/python"
tar xf "$sources"/libffi_*.orig.tar.gz -C "$work/libffi" --strip-components 1
tar xf "$sources"/python3.11_*.orig.tar.gz -C "$work/python" --strip-components 1
cd "$work/libffi"
./configure --host="$host" --prefix="$prefix" --disable-shared --with-pic --disable-docs --disable-multi-os-directory \
  --disable-exec-static-tramp
make -j "$jobs"
make install

# Its programs run here beside Debian's musl, so that nothing is left to guess.
cd "$work/python"
CPPFLAGS="-I$prefix/include" LDFLAGS="-dynamic -L$prefix/lib" ./configure --build="$host" --host="$host" --prefix="$prefix/python" --with-ensurepip=no \
  --disable-test-modules ac_cv_func_preadv2=no ac_cv_func_pwritev2=no  # not in Debian's musl
make -j "$jobs" build_all
make altbininstall libinstall sharedinstall inclinstall
ln -sf python3.11 "$prefix/python/bin/python3"
"$prefix/python/bin/python3" -c 'import ctypes, zlib, sysconfig; print(sysconfig.get_platform(), sysconfig.get_config_var("SOABI"))'
