#!/usr/bin/env bash
# ./run.sh [SURFACE] [OPTIONS of roughcontact solve]
# Installs what is missing, builds the command, and presses SURFACE against a flat. Without SURFACE: a rubber seal on lapped steel. With
# SURFACE and without OPTIONS: three loads, E* = 100 GPa, heights and pitch in micrometres (pitch 1) if the file does not say. SURFACE
# is levelled unless OPTIONS has a --remove (none: as it is). With --out DIR and --resume among the OPTIONS a history that was
# interrupted goes on. If Python has Jinja2 and Plotly, a page with all of it is written beside the pictures.
set -euo pipefail
root=$(cd "$(dirname "$0")" && pwd)
build=$root/build-run

# Only what the command needs; all backends and libraries, as the Python package has them, if OPTIONS name one.
targets=(roughcontact_command rcb_fft)
case "$*" in *--backend* | *--solver* | *certify_backend*) targets+=(roughcontact_python) ;; esac
page=no
! python3 -c 'import jinja2, numpy, plotly' 2>/dev/null || { page=yes; targets+=(roughcontact_formats roughcontact_surface); }

# progress: shows the percentages of a build's output: on a terminal in one line, elsewhere in a line for each ten percent.
progress() {
  local line percent last=-10
  while IFS= read -r line; do
    [[ $line =~ ^\[\ *([0-9]+)%\] ]] || continue
    percent=${BASH_REMATCH[1]}
    if [ -t 1 ]; then
      printf '\rcompiling: %3d %%' "$percent"
    elif [ "$percent" -ge $((last + 10)) ]; then
      echo "compiling: $percent %"
      last=$percent
    fi
  done
  [ ! -t 1 ] || echo
}

# up_to_date: whether the last build had these targets, and no file that it may have read has changed since it began.
up_to_date() {
  [ -e "$build/built" ] && [ "$(cat "$build/built")" = "${targets[*]}" ] &&
    [ -z "$(find "$root"/{CMakeLists.txt,CMakePresets.json,backends,bindings,cmake,formats,include,mpi,packaging,pkgconfig,src,surface,tools} -newer "$build/built" -print -quit)" ]
}

if ! up_to_date; then
  "$root/scripts/bootstrap.sh"
  mkdir -p "$build"
  log=$build/build.log
  echo "building the command in $build, by $(nproc) processes"
  touch "$build/started"
  { (cd "$root" && cmake --preset run) && NINJA_STATUS='[%p] ' cmake --build "$build" -j "$(nproc)" --target "${targets[@]}"; } 2>&1 |
    tee "$log" | progress || { grep -E -m 20 'error|Error' "$log" || tail -30 "$log"; echo "the build failed: $log"; exit 1; }
  echo "${targets[*]}" >"$build/started.new"
  touch -r "$build/started" "$build/started.new"
  mv "$build/started.new" "$build/built"
fi

surface=
if [ $# -gt 0 ] && [[ $1 != -* ]]; then surface=$1; shift; fi
options=("$@")
[[ -z $surface || " ${options[*]} " =~ \ --remove[\ =] ]] || options+=(--remove plane)
demo=no
if [ -z "$surface" ]; then
  surface=$build/demo/steel.gsf
  mkdir -p "$build/demo"
  "$build/bin/roughcontact" generate spectral --output "$surface" --size 512 --pitch 1um --rolloff 128um --shortest 8um --rms-slope 0.05
  options+=(--boundary periodic)
  [ $# -gt 0 ] || { demo=yes; options+=(--E 10MPa --nu 0.5 --pressure '20kPa,50kPa,100kPa'); }
elif [ $# = 0 ]; then
  options+=(--modulus 1e11 --pressure '5e7,5e8,2e9')
  case $surface in
    *.npy | *.txt | *.csv | *.tsv | *.dat | *.asc) options+=(--unit um --pitch 1) ;;
    *.xyz) options+=(--unit um) ;;
  esac
fi
out=$build/demo/out
for ((i = 0; i < ${#options[@]} - 1; ++i)); do
  [ "${options[i]}" != --out ] || out=${options[i + 1]}
done
[[ " ${options[*]} " == *" --out "* ]] || options+=(--out "$out")

status=0
"$build/bin/roughcontact" solve "$surface" "${options[@]}" || status=$?
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
  PYTHONPATH=$root/bindings/python ROUGHCONTACT_LIBRARY=$build/lib/libroughcontact.so \
    python3 -m roughcontact report "$surface" "${asked[@]}" --out "$out/report.html" >/dev/null && echo "page: $out/report.html" || true
else
  echo "for a page with all of this, which opens in a browser: pip install jinja2 plotly (Debian: in a venv), and run it again"
fi
if [ $demo = yes ] && [ $status = 0 ]; then
  echo "How much of a rubber seal (E = 10 MPa) touches lapped steel (rms height 0.44 um)?"
  awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) { name = $i; sub(/ \[.*/, "", name); at[name] = i } }
    NR > 1 { answer = answer (NR > 2 ? ", " : "") sprintf("%.3g %% under %g kPa", 100 * $at["area_fraction"], $at["mean_pressure"] / 1000)
      largest = $at["max_pressure"] / 1e6 }
    END { printf "%s; the largest pressure is %.2g MPa.\n", answer, largest }' "$out/steps.csv"
fi
exit $status
