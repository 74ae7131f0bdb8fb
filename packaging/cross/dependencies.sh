#!/bin/sh
# Builds what the surface and formats libraries link, for another system, as static libraries.
# Usage: dependencies.sh TOOLCHAIN.cmake HOST PREFIX
# HOST: the name of GNU's tools for that system, x86_64-w64-mingw32 for example. PREFIX: where they go; what is there is not built again.
# The sources are those of Debian's source packages of gsl, libzip, pugixml and zlib.
set -eu
toolchain=$(realpath "$1") host=$2
mkdir -p "$3"
prefix=$(realpath "$3")
work=$prefix/work
mkdir -p "$work/lists/partial"
cd "$work"

# Debian's own sources, without a change to this machine's lists of packages.
sources() {
  sed 's/^Types: deb$/Types: deb-src/' /etc/apt/sources.list.d/debian.sources >sources.sources
  set -- -q -o Dir::Etc::sourcelist="$work/sources.sources" -o Dir::Etc::sourceparts=/dev/null -o Dir::State::lists="$work/lists" \
    -o APT::Sandbox::User=root
  apt-get "$@" update >/dev/null
  apt-get "$@" source --download-only gsl libzip pugixml zlib >/dev/null
}

unpack() {
  rm -rf "$1"
  mkdir "$1"
  tar xf "$1"_*.orig.tar.* -C "$1" --strip-components 1
}

by_cmake() {
  name=$1
  shift
  unpack "$name"
  cmake -S "$name" -B "$name/build" -DCMAKE_TOOLCHAIN_FILE="$toolchain" -DCMAKE_INSTALL_PREFIX="$prefix" -DCMAKE_PREFIX_PATH="$prefix" \
    -DCMAKE_FIND_ROOT_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF "$@"
  cmake --build "$name/build" -j "$(nproc)"
  cmake --install "$name/build"
}

made() { [ -e "$prefix/lib/$1" ]; }

ls gsl_*.orig.tar.* zlib_*.orig.tar.* >/dev/null 2>&1 || sources
if ! made libz.a; then
  unpack zlib
  (cd zlib && CC="${CC:-$host-gcc}" AR="$host-ar" RANLIB="$host-ranlib" CHOST=$host ./configure --static --prefix="$prefix" && make -j "$(nproc)" libz.a &&
    mkdir -p "$prefix/lib/pkgconfig" "$prefix/include" && cp libz.a "$prefix/lib" && cp zlib.h zconf.h "$prefix/include" && cp zlib.pc "$prefix/lib/pkgconfig")
fi
made libpugixml.a || by_cmake pugixml
made libzip.a || by_cmake libzip -DENABLE_COMMONCRYPTO=OFF -DENABLE_GNUTLS=OFF -DENABLE_MBEDTLS=OFF -DENABLE_OPENSSL=OFF \
  -DENABLE_WINDOWS_CRYPTO=OFF -DENABLE_BZIP2=OFF -DENABLE_LZMA=OFF -DENABLE_ZSTD=OFF -DBUILD_TOOLS=OFF -DBUILD_REGRESS=OFF \
  -DBUILD_EXAMPLES=OFF -DBUILD_DOC=OFF
if ! made libgsl.a; then
  unpack gsl
  (cd gsl && ./configure --host="$host" ${CC:+CC="$CC"} --prefix="$prefix" --disable-shared --quiet && make -j "$(nproc)" --quiet &&
    make --quiet install-libLTLIBRARIES install-pkgconfigDATA && make --quiet -C gsl install && make --quiet install-binSCRIPTS)
fi
