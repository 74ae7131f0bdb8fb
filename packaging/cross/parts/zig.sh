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
version=$(echo "$venv"/lib/python3*/site-packages/ziglang-*.dist-info)
for tool in cc c++ ar ranlib; do
  {
    echo "#!/bin/sh"
    echo "# ${version##*/}"  # compiler caches compare this text
    echo 'here=${0%/*} last='
    target=''
    if [[ $tool == c* ]]; then
      # Without -g0 and -s it writes what debuggers need, folders of the build among it. It checks for undefined behaviour where -O0 is
      # asked for.
      target="-target $2 -O2 -g0 -fno-sanitize=undefined"
      echo "case \" \$* \" in *' -c '*) ;; *) last='-O2 -s' ;; esac"  # one build of the C++ library, whatever the flags
    fi
    echo "ZIG_LOCAL_CACHE_DIR=\$here/cache exec \"\$here/${zig#"$folder"/}\" $tool $target \"\$@\" \$last"
  } >"$folder/$2-$tool"
  chmod +x "$folder/$2-$tool"
done
