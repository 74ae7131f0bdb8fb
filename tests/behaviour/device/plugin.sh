#!/usr/bin/env bash
# plugin.sh SOURCE FOLDER PYTHON: the plugin for devices itself, made by nvcc: without a warning, with one symbol for others and no mutable
# data beyond .ci/globals.allow. With a device it solves; without one it is refused in the driver's words. Exit status 77 without nvcc.
# ARCHITECTURES: those to compile for.
set -euo pipefail
source=$1 build=$2 python=$3
command -v nvcc >/dev/null || { echo "skipped: nvcc is not found"; exit 77; }
mkdir -p "$build"
cmake -S "$source" -B "$build" -DCMAKE_BUILD_TYPE=Release -DRC_CUDA=ON -DRC_CUDA_ARCHITECTURES="${ARCHITECTURES:-80-real;90-real;100}" \
  -DRC_BUILD_TESTS=OFF -DRC_BUILD_EXAMPLES=OFF -DRC_BUILD_TOOLS=OFF -DRC_BUILD_FORMATS=OFF -DRC_BUILD_BENCH=OFF -DRC_BUILD_SURFACE=OFF \
  -DRC_BUILD_MPI=OFF -DRC_BUILD_DEVICE_BENCH=ON -DRC_BUILTIN_BACKENDS= -DRC_MODULE_BACKENDS= >"$build/build.log" 2>&1 ||
  { tail -20 "$build/build.log"; exit 1; }
cmake --build "$build" --parallel 2 --target roughcontact rcb_cuda device_passes >>"$build/build.log" 2>&1 ||
  { tail -20 "$build/build.log"; exit 1; }
! grep -i warning "$build/build.log" || exit 1
plugin=$(echo "$build"/lib/roughcontact/*/rcb_cuda.so)
# A constant of the host in code for the device becomes a trap there.
"$(command -v nvcc)" -x cu -std=c++20 -O3 -fmad=false --expt-relaxed-constexpr -arch=sm_80 -ptx -I"$source/include" -I"$source/src" \
  -I"$source/backends" -I"$source/backends/cuda" -o "$build/many.ptx" "$source/backends/cuda/small/many.cpp"
! grep -n 'trap;' "$build/many.ptx" || exit 1
symbols=$(nm -D --defined-only "$plugin" | awk '$2 == "T" || $3 ~ /rc_|2rc|roughcontact/ { print $3 }')  # the others are the standard library's
[ "$symbols" = rc_plugin_query ] || { echo "others can see: $symbols"; exit 1; }
"$source/.ci/globals.sh" "$build"
solve=(env ROUGHCONTACT_LIBRARY="$build/lib/libroughcontact.so" PYTHONPATH="$source/bindings/python" "$python" -B -c '
import numpy, roughcontact as rc
try:
    gap = numpy.random.default_rng(1).random((64, 64))
    contact = rc.Contact(rc.HalfSpace((64, 64), pitch=1, modulus=1, boundary="free"), options={"solver": "haar-cuda", "backend": "cuda"})
    print(contact.solve(undeformed_gap=gap, load=10).status.name)
except rc.RoughContactError as error:
    print(error)')
answer=$("${solve[@]}")
echo "$answer"
if nvidia-smi -L >/dev/null 2>&1; then
  grep -qx OK <<<"$answer"
else
  grep -q 'cuda: no device: .*; driver for CUDA .*, built with CUDA' <<<"$answer"
fi

# What other drivers say, and a device that answers no call: WORDS, then as in other_driver.c.
"${CC:-cc}" -shared -fPIC -I"$(dirname "$(readlink -f "$(command -v nvcc)")")/../include" -o "$build/other_driver.so" "$source/tests/behaviour/device/other_driver.c"
other() {
  local answer
  answer=$(RC_OTHER_DRIVER="${*:2}" LD_PRELOAD=$build/other_driver.so "${solve[@]}")
  grep -q "$1" <<<"$answer" || { echo "lacks \"$1\": $answer"; exit 1; }
}
other 'no device: CUDA driver version is insufficient for CUDA runtime version; driver for CUDA 11.4, built with CUDA' 35 0 11040 0
other 'no device: no CUDA-capable device is detected; driver for CUDA 13.0' 100 0 13000 0
other 'no device: the driver has none' 0 0 13000 0
other 'none of 2 device(s) has compute capability 8.0 or above' 0 2 13000 75
nvidia-smi -L >/dev/null 2>&1 || other 'cuda: cuda[A-Za-z]*: .*; the contact can go on with another backend' 0 1 13000 90
echo "one symbol for others, no warning; compiled for $(sed -n "s/^RC_CUDA_ARCHITECTURES:[A-Z]*=//p" "$build/CMakeCache.txt")"
