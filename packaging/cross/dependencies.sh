#!/usr/bin/env bash
# dependencies.sh SYSTEM FOLDER: builds what this project links, for another system, as static libraries below FOLDER/SYSTEM; what is
# there is not built again. The sources are those of Debian's source packages, kept in FOLDER/sources.
set -euo pipefail
toolchain=$(dirname "$(realpath "$0")")/$1.cmake
mkdir -p "$2/$1/include" "$2/$1/share/cmake"
folder=$(realpath "$2") prefix=$(realpath "$2/$1")
system='' host='' cc='' ar='' ranlib=''
eval "$(cmake -DTOOLCHAIN="$toolchain" -P "$(dirname "$toolchain")/parts/describe.cmake")"
jobs=$(nproc)
export PKG_CONFIG_LIBDIR=$prefix/lib/pkgconfig

"$(dirname "$toolchain")/parts/sources.sh" "$folder/sources" cmocka fftw3 gsl libzip pugixml zlib

unpack() {
  cd "$prefix"
  rm -rf unpacked
  mkdir unpacked
  tar xf "$(ls "$folder/sources/$1"_*.orig.tar.* | grep -v "\.asc$")" -C "$prefix/unpacked" --strip-components 1
}

by_cmake() { # by_cmake NAME OPTION...
  unpack "$1"
  cmake -S "$prefix/unpacked" -B "$prefix/unpacked/build" -DCMAKE_TOOLCHAIN_FILE="$toolchain" -DCMAKE_INSTALL_PREFIX="$prefix" \
    -DCMAKE_FIND_ROOT_PATH="$prefix" -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF \
    -DCMAKE_POSITION_INDEPENDENT_CODE=ON "${@:2}"
  cmake --build "$prefix/unpacked/build" -j "$jobs"
  cmake --install "$prefix/unpacked/build"
}

made() { [ -e "$prefix/lib/$1" ]; }

made libz.a || {
  unpack zlib
  cd "$prefix/unpacked"
  # For macOS it would define a macro of the name fdopen, and call that system's own archiver.
  CC="${CMAKE_C_COMPILER_LAUNCHER:-} $cc" AR=$ar RANLIB=$ranlib CHOST=$host CFLAGS="-O2 -fPIC -Dfdopen=fdopen" ./configure --static --prefix="$prefix"
  make -j "$jobs" AR="$ar" ARFLAGS=rcs libz.a
  mkdir -p "$prefix/lib/pkgconfig"
  cp zlib.pc "$prefix/lib/pkgconfig"
  cp zlib.h zconf.h "$prefix/include"
  cp libz.a "$prefix/lib"
}
made libpugixml.a || by_cmake pugixml
made libzip.a || by_cmake libzip -DENABLE_COMMONCRYPTO=OFF -DENABLE_GNUTLS=OFF -DENABLE_MBEDTLS=OFF -DENABLE_OPENSSL=OFF \
  -DENABLE_WINDOWS_CRYPTO=OFF -DENABLE_BZIP2=OFF -DENABLE_LZMA=OFF -DENABLE_ZSTD=OFF -DBUILD_TOOLS=OFF -DBUILD_REGRESS=OFF \
  -DBUILD_EXAMPLES=OFF -DBUILD_DOC=OFF
made libcmocka.a || {
  by_cmake cmocka -DWITH_EXAMPLES=OFF -DWITH_STATIC_LIB=ON
  rm "$prefix"/lib/libcmocka*
  cp "$prefix/unpacked/build/src/libcmocka-static.a" "$prefix/lib/libcmocka.a"
}
sse2=OFF
[[ $host != x86_64-* ]] || sse2=ON
export CFLAGS=-DWITH_OUR_MALLOC  # its CMake files do not look for the system's own call for aligned memory
made libfftw3.a || by_cmake fftw3 -DENABLE_THREADS=ON -DENABLE_SSE2=$sse2 -DBUILD_TESTS=OFF
made libfftw3f.a || by_cmake fftw3 -DENABLE_FLOAT=ON -DENABLE_THREADS=ON -DENABLE_SSE=$sse2 -DENABLE_SSE2=$sse2 -DBUILD_TESTS=OFF
unset CFLAGS
made libgsl.a || {
  unpack gsl
  cd "$prefix/unpacked"
  CC="${CMAKE_C_COMPILER_LAUNCHER:-} $cc" AR=$ar RANLIB=$ranlib ./configure --host="$host" --prefix="$prefix" --disable-shared --with-pic --quiet CFLAGS=-O2
  # The library of surfaces takes transforms, lines through points and the digamma function; these folders have them.
  parts=(err sys complex fft fit specfunc)
  make -j "$jobs" --quiet -C gsl
  make --quiet gsl.pc
  for part in "${parts[@]}"; do
    make -j "$jobs" --quiet -C "$part" "libgsl$part.la"
    $ar crs libgsl.a "$part"/*.o
  done
  mkdir -p "$prefix/include/gsl" "$prefix/lib/pkgconfig"
  cp -L gsl/*.h "$prefix/include/gsl"
  sed 's/-lgslcblas//' gsl.pc >"$prefix/lib/pkgconfig/gsl.pc"
  cp libgsl.a "$prefix/lib"
}
cd "$prefix"
rm -rf unpacked

# Libraries that are headers alone come from this machine: their folder holds headers of this machine as well.
for name in CLI nlohmann; do cp -r /usr/include/$name "$prefix/include"; done
for name in CLI11 nlohmann_json; do cp -r /usr/share/cmake/$name "$prefix/share/cmake"; done
