#!/usr/bin/env bash
# bench/device_resources.sh [--update]: registers, spills and shared memory of every kernel of backends/cuda and of the functions
# that they call, for each architecture, as a table of Markdown; --update writes it into docs/development/device.md. Needs nvcc (NVCC=...), no device.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root/backends/cuda"
nvcc=${NVCC:-nvcc}
architectures=${ARCHITECTURES:-80 90 100}
log=$(mktemp)
trap 'rm -f "$log"' EXIT
for architecture in $architectures; do
  for source in engine history operator small/many solver trees; do
    echo "architecture $architecture" >>"$log"
    "$nvcc" -x cu -std=c++20 -O3 -fmad=false --expt-relaxed-constexpr -arch="sm_$architecture" -cubin -Xptxas -v -I"$root/include" -I"$root/src" \
      -I"$root/backends" -I. -o /dev/null $source.cpp >>"$log" 2>&1
  done
done
python3 "$root/bench/device_resources.py" "$log" "$("$nvcc" --version | sed -n 's/.*release \([0-9.]*\).*/\1/p')" ${1:+"$root/docs/development/device.md"}
