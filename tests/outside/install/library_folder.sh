#!/usr/bin/env bash
# library_folder.sh SOURCE BUILD CC CXX PYTHON: the Python package finds the library of its installation, whatever the libraries' folder is
# called, after the tree was staged (DESTDIR) and moved.
set -euo pipefail
source=$1 build=$2 cc=$3 cxx=$4 python=$5
pc=
. "$(dirname "$0")/scratch.sh"
library=$(find "$build/lib" -name 'libroughcontact.so.*' -type l | head -n 1)
for folder in lib64 lib/x86_64-linux-gnu; do
  out=$scratch/${folder%%/*}
  cmake -S "$source" -B "$out/build" -DCMAKE_INSTALL_PREFIX=/opt/contact -DCMAKE_INSTALL_LIBDIR=$folder -DCMAKE_C_COMPILER="$cc" \
    -DCMAKE_CXX_COMPILER="$cxx" -DRC_MODULE_BACKENDS= -DRC_CUDA=OFF -DRC_BUILD_{SURFACE,FORMATS,TOOLS,TESTS,EXAMPLES,BENCH,MPI}=OFF >"$scratch/log" 2>&1 ||
    { cat "$scratch/log"; fail "CMAKE_INSTALL_LIBDIR=$folder cannot be configured"; }
  DESTDIR="$out/stage" cmake --install "$out/build" --component python >/dev/null
  mkdir -p "$out/stage/opt/contact/$folder"
  cp "$library" "$out/stage/opt/contact/$folder"
  mv "$out/stage/opt/contact" "$out/moved tree"
  found=$(clean PYTHONPATH="$out/moved tree/lib/python3/dist-packages" "$python" -c 'import roughcontact as rc; print(rc.version(), rc.library_file())') ||
    fail "$folder: the package does not find the library"
  [[ $found == *" $out/moved tree/$folder/"* ]] || fail "$folder: the package loads $found"
  echo "$folder: ok"
done
