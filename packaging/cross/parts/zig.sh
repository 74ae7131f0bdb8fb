#!/usr/bin/env bash
# zig.sh FOLDER TARGET: makes FOLDER/TARGET-cc, TARGET-c++, TARGET-ar and TARGET-ranlib, which are clang and its tools with the C and C++
# libraries of TARGET, out of the Python package ziglang; pip fetches it once.
set -euo pipefail
mkdir -p "$1"
folder=$(realpath "$1")
venv=$folder/venv
exec 9>"$folder/lock"
flock 9  # several systems may begin at once
[ -d "$venv/ready" ] || {
  rm -rf "$venv"
  python3 -m venv "$venv"
  "$venv/bin/pip" install -q "ziglang==0.17.*"
  mkdir "$venv/ready"
}
zig=$(echo "$venv"/lib/python3*/site-packages/ziglang/zig)
for tool in cc c++ ar ranlib; do
  target=''
  [[ $tool != c* ]] || target="-target $2 -O2"  # one build of the C++ library, whatever the flags
  printf '#!/bin/sh\nZIG_LOCAL_CACHE_DIR=%q exec %q %s %s "$@"\n' "$folder/cache" "$zig" $tool "$target" >"$folder/$2-$tool"
  chmod +x "$folder/$2-$tool"
done
