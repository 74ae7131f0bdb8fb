#!/usr/bin/env bash
# bench/device.sh [BUILD]: on a machine with a CUDA device, in less than ten minutes: builds, measures solves, batches and passes, and
# writes bench/results/device.json and the tables of docs/device.md. Exit status 77 where there is no device: nothing is written then.
# Needs nvcc, cuFFT, cmake; FFTW for the times on two threads of the host, which are left out without it.
# RC_DEVICE_SECONDS: time limit of the whole run (540). RC_DEVICE_READY=1: does not build; BUILD has the programs. RC_DEVICE_COMMIT: the
# commit, if this folder is no git repository.
# RC_DEVICE_PAIR="haar-cuda-host cuda-host" RC_DEVICE_PASSES=device_passes_host RC_DEVICE_SHORT=1: the same steps on the host, on small
# grids, for tests; nothing is written but to RC_DEVICE_OUTPUT.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build-device}
read -r solver backend <<<"${RC_DEVICE_PAIR:-haar-cuda cuda}"
passes=${RC_DEVICE_PASSES:-device_passes}
lines=$build/device-lines  # what was measured, should anything fail later
mkdir -p "$build"
rm -f "$lines" "$lines.passes"
ends=$((SECONDS + ${RC_DEVICE_SECONDS:-540}))
fft=fft
if [ -z "${RC_DEVICE_SHORT:-}" ]; then
  command -v nvcc >/dev/null || PATH=$PATH:/usr/local/cuda/bin
  if [ -z "${RC_DEVICE_READY:-}" ]; then
    architecture=$(nvidia-smi --query-gpu=compute_cap --format=csv,noheader 2>/dev/null | head -1 | tr -d . || true)
    pkg-config --exists fftw3 fftw3f 2>/dev/null || fft=''
    cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DRC_CUDA=ON -DRC_CUDA_ARCHITECTURES="${RC_DEVICE_ARCHITECTURE:-${architecture:-native}}" \
      -DRC_BUILD_TESTS=OFF -DRC_BUILD_EXAMPLES=OFF -DRC_BUILD_TOOLS=OFF -DRC_BUILD_FORMATS=OFF -DRC_BUILD_BENCH=OFF -DRC_BUILD_SURFACE=OFF \
      -DRC_BUILD_DEVICE_BENCH=ON -DRC_BUILTIN_BACKENDS= -DRC_MODULE_BACKENDS="$fft" >"$build/build.log" 2>&1 || { tail -20 "$build/build.log"; exit 1; }
    cmake --build "$build" -j "$(nproc)" --target roughcontact ${fft:+rcb_fft} rcb_cuda device_solves device_passes >>"$build/build.log" 2>&1 || {
      tail -20 "$build/build.log"; exit 1; }
  fi
  commit=${RC_DEVICE_COMMIT:-$(git describe --always --dirty --abbrev=12 2>/dev/null || echo unknown)}
  device=$(nvidia-smi --query-gpu=name,driver_version,memory.total --format=csv,noheader 2>/dev/null | head -1 || echo unknown)
  memory=$(nvidia-smi --query-gpu=memory.total --format=csv,noheader,nounits 2>/dev/null | head -1 || echo 0)
  largest=8192 sizes="1024 4096" large=16384:1e-4 count=20000 few_count=2000 batch_threads="1 2 4 $(nproc)"
  [ "${memory:-0}" -lt 130000 ] || large="$large 32768:1e-8"  # which takes so much [MiB]
else
  commit=test device=host largest=64 sizes=128 large=160:1e-4 count=20 few_count=20 batch_threads=2
fi
status=0
"$build/bin/$passes" 64 >"$lines.passes" || status=$?
if [ $status -ne 0 ]; then
  [ $status -ne 77 ] || echo "bench/device.sh: no device answers; nothing is measured, and docs/device.md stays as it is" >&2
  exit $status
fi

# run SECONDS ARGUMENTS: one more line, unless the time is up.
run() {
  local left=$((ends - SECONDS)) limit=$1
  shift
  [ "$limit" -le "$left" ] || limit=$left
  if [ "$limit" -lt 5 ]; then
    echo "{\"left_out\": \"$*\"}" >>"$lines"
  else
    timeout "$limit" "$build/bin/device_solves" "$@" >>"$lines" ||
      echo "{\"failed\": \"device_solves $*: status $? (124: after $limit s)\"}" >>"$lines"
  fi
  tail -1 "$lines"
}
for n in $sizes; do
  for control in load approach; do
    run 60 "$n" $control 1e-8 "$solver" "$backend" "$(nproc)" 5
    [ -z "$fft" ] || run 90 "$n" $control 1e-8 haar-cg fft 2 2
  done
done
for threads in $batch_threads; do run 60 batch $count "$solver" "$backend" "$threads"; done
[ -z "$fft" ] || run 60 batch $few_count haar-cg fft 2
timeout 60 "$build/bin/$passes" "$largest" >"$lines.passes" || echo "{\"failed\": \"$passes $largest: status $?\"}" >>"$lines"
for each in $large; do run 200 "${each%:*}" load "${each#*:}" "$solver" "$backend" "$(nproc)" 2; done
output=${RC_DEVICE_OUTPUT:-bench/results/device.json}
document=docs/device.md
[ -z "${RC_DEVICE_OUTPUT:-}" ] || document=''
python3 bench/device_tables.py "$lines" "$lines.passes" "$output" "$commit" "$device" $document
