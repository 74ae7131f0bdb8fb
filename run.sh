#!/usr/bin/env bash
# ./run.sh [SURFACE] [OPTIONS of roughcontact solve]
# Installs what is missing, builds, and presses SURFACE against a flat. Without SURFACE a rough one is generated; without OPTIONS
# it is loaded in three steps, E* = 100 GPa, heights and pitch in micrometres (pitch 1) where the file does not say. SURFACE is
# levelled unless OPTIONS has a --remove (none: as it is). With --out DIR and --resume among the OPTIONS a history that was
# interrupted goes on. Where Python has Jinja2 and Plotly, a page with all of it is written beside the pictures.
set -euo pipefail
root=$(cd "$(dirname "$0")" && pwd)
"$root/scripts/bootstrap.sh"

targets=(roughcontact_command rcb_fft)
page=no
! python3 -c 'import jinja2, numpy, plotly' 2>/dev/null || { page=yes; targets+=(roughcontact_python); }

mkdir -p "$root/build"
log=$root/build/build.log
echo "building in $root/build"
{ cmake -S "$root" --preset release && cmake --build "$root/build" -j "$(nproc)" --target "${targets[@]}"; } >"$log" 2>&1 ||
  { tail -30 "$log"; echo "the build failed: $log"; exit 1; }

surface=
if [ $# -gt 0 ] && [[ $1 != -* ]]; then surface=$1; shift; fi
options=("$@")
[[ -z $surface || " ${options[*]} " =~ \ --remove[\ =] ]] || options+=(--remove plane)
if [ $# = 0 ]; then
  options+=(--modulus 1e11 --pressure '5e7,5e8,2e9')
  case $surface in
    '' | *.npy | *.txt | *.csv | *.tsv | *.dat | *.asc) options+=(--unit um --pitch 1) ;;
    *.xyz) options+=(--unit um) ;;
  esac
fi
if [ -z "$surface" ]; then
  surface=$root/build/demo/surface.npy
  mkdir -p "$root/build/demo"
  "$root/build/bin/roughcontact" generate spectral --output "$surface" --size 512 --rolloff 128 --rms-slope 0.1
fi
out=$root/build/demo/out
for ((i = 0; i < ${#options[@]} - 1; ++i)); do
  [ "${options[i]}" != --out ] || out=${options[i + 1]}
done
[[ " ${options[*]} " == *" --out "* ]] || options+=(--out "$out")

status=0
"$root/build/bin/roughcontact" solve "$surface" "${options[@]}" || status=$?
for picture in "$out"/contact-*.png; do
  [ ! -e "$picture" ] || [ $status = 1 ] || echo "picture: $picture"
done

# The page takes the options that say what is pressed and how; those of the folder are the command's alone.
asked=()
for ((i = 0; i < ${#options[@]}; ++i)); do
  case ${options[i]} in
    --out) i=$((i + 1)) ;;
    --out=* | --resume | --quiet | --explain) ;;
    *) asked+=("${options[i]}") ;;
  esac
done
if [ $status = 1 ] || [ $status -gt 2 ]; then
  :
elif [ $page = yes ]; then
  PYTHONPATH=$root/bindings/python ROUGHCONTACT_LIBRARY=$root/build/lib/libroughcontact.so \
    python3 -m roughcontact report "$surface" "${asked[@]}" --out "$out/report.html" >/dev/null && echo "page: $out/report.html" || true
else
  echo "for a page with all of this, which opens in a browser: pip install jinja2 plotly (Debian: in a venv), and run it again"
fi
exit $status
