#!/usr/bin/env bash
# reference.sh DIRECTORY: the reference of the public headers as a web site, DIRECTORY/html/index.html. A warning is an error;
# exit code 77 without doxygen.
set -euo pipefail
[ $# = 1 ] || { echo "usage: $0 DIRECTORY"; exit 1; }
command -v doxygen >/dev/null || { echo "skipped: doxygen is not installed"; exit 77; }
out=$1
mkdir -p "$out"
out=$(cd "$out" && pwd)
cd "$(dirname "$0")/.."
version=$(sed -nE 's/^project\(.* VERSION ([0-9.]+).*/\1/p' CMakeLists.txt)
{ cat docs/Doxyfile; echo "OUTPUT_DIRECTORY = \"$out\""; echo "PROJECT_NUMBER = $version"; } | doxygen - >/dev/null
echo "$(find "$out/html" -name '*.html' | wc -l) pages in $out/html"
