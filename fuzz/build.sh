#!/usr/bin/env bash
# Builds the fuzz targets as OSS-Fuzz does: CC, CXX, CFLAGS, CXXFLAGS, LIB_FUZZING_ENGINE and OUT say how and where to, WORK where to
# build. Without them: clang with libFuzzer, address and undefined behaviour sanitizers, in build-oss-fuzz/. OUT gets each target
# <name>_fuzzer with its <name>_fuzzer.dict and <name>_fuzzer_seed_corpus.zip, and in lib/ the libraries that they need.
# DEPENDENCIES: a folder in which `apt-get source libzip pugixml` was run; these two are then built with the same flags and linked
# in.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
export CC=${CC:-clang} CXX=${CXX:-clang++}
export CFLAGS=${CFLAGS--O1 -g1 -fno-omit-frame-pointer -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all}
export CXXFLAGS=${CXXFLAGS-$CFLAGS}
LIB_FUZZING_ENGINE=${LIB_FUZZING_ENGINE:--fsanitize=fuzzer}
OUT=${OUT:-$root/build-oss-fuzz/out} WORK=${WORK:-$root/build-oss-fuzz/work}
jobs=$(nproc)
mkdir -p "$OUT/lib" "$WORK"

# dependency NAME [CMake options]: the sources DEPENDENCIES/NAME-*, static, into WORK/installed.
dependency() {
  cmake -S "$(echo "$DEPENDENCIES/$1"-*/)" -B "$WORK/$1" -DCMAKE_BUILD_TYPE=Debug -DBUILD_SHARED_LIBS=OFF \
    -DCMAKE_C_FLAGS_DEBUG= -DCMAKE_CXX_FLAGS_DEBUG= -DCMAKE_INSTALL_PREFIX="$WORK/installed" -DCMAKE_INSTALL_LIBDIR=lib "${@:2}"
  cmake --build "$WORK/$1" -j "$jobs"
  cmake --install "$WORK/$1"
}
if [ -n "${DEPENDENCIES:-}" ]; then
  dependency libzip -DBUILD_TOOLS=OFF -DBUILD_REGRESS=OFF -DBUILD_EXAMPLES=OFF -DBUILD_DOC=OFF -DENABLE_BZIP2=OFF -DENABLE_LZMA=OFF \
    -DENABLE_ZSTD=OFF -DENABLE_COMMONCRYPTO=OFF -DENABLE_GNUTLS=OFF -DENABLE_MBEDTLS=OFF -DENABLE_OPENSSL=OFF
  dependency pugixml
  export PKG_CONFIG_PATH=$WORK/installed/lib/pkgconfig${PKG_CONFIG_PATH:+:$PKG_CONFIG_PATH}
fi

cmake -S "$root" -B "$WORK/roughcontact" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_FLAGS_DEBUG= -DCMAKE_CXX_FLAGS_DEBUG= \
  -DCMAKE_PREFIX_PATH="$WORK/installed" -DCMAKE_EXE_LINKER_FLAGS='-Wl,-rpath,$ORIGIN/lib' \
  -DRC_BUILD_FUZZERS=ON -DRC_READ_HDF5=ON -DRC_FUZZING_ENGINE="$LIB_FUZZING_ENGINE" -DRC_BUILD_TOOLS=OFF -DRC_BUILD_TESTS=OFF -DRC_BUILD_EXAMPLES=OFF \
  -DRC_BUILD_BENCH=OFF -DRC_BUILTIN_BACKENDS='dense;fft;split;cholmod' -DRC_MODULE_BACKENDS=
cmake --build "$WORK/roughcontact" -j "$jobs" --target fuzzers

for target in "$WORK"/roughcontact/bin/*_fuzzer; do
  name=$(basename "$target" _fuzzer)
  cp "$target" "$OUT/"
  cp "$root/fuzz/$name.dict" "$OUT/${name}_fuzzer.dict"
  rm -f "$OUT/${name}_fuzzer_seed_corpus.zip"
  (cd "$root/fuzz/corpus/$name" && python3 -m zipfile -c "$OUT/${name}_fuzzer_seed_corpus.zip" ./*)
  ldd "$target" | awk '$3 ~ /^\// && $1 !~ /^(libc|libm|libgcc_s|libpthread|libdl|librt)\./ { print $3 }' | xargs -r cp -Lu -t "$OUT/lib"
done
echo "fuzz targets: $OUT"
