#!/usr/bin/env bash
# ./run.sh [SURFACE] [OPTIONS of roughcontact solve] [--page]
#
# Installs what is missing, builds the command, and presses SURFACE against a flat. Without SURFACE: a rubber seal on lapped steel, a
# generated map, without adhesion, which would add some contact (docs/how-to/limits.md).
#
# Options that are left out have defaults: E* = 100 GPa (seal: E = 10 MPa, nu = 0.5); the mean pressures 50 MPa, 500 MPa and 2 GPa
# (seal: 20, 50 and 100 kPa); --remove plane; heights and pitch in micrometres and a pitch of 1, if the file cannot say them;
# --out build-run/demo/out. --page also writes report.html there, which needs Jinja2, NumPy and Plotly for Python.
# --out DIR --resume continues an interrupted history. All options: roughcontact solve --help, docs/command-line.md.
set -euo pipefail
root=$(cd "$(dirname "$0")" && pwd)
build=$root/build-run

options=()
page=no
for word in "$@"; do
  case $word in
    --help | -h) sed -n '2,/^set/ { /^#/ { s/^# \{0,1\}//; p } }' "$root/run.sh"; exit 0 ;;
    --page) page=yes ;;
    *) options+=("$word") ;;
  esac
done
surface=
if [ ${#options[@]} -gt 0 ] && [[ ${options[0]} != -* ]]; then surface=${options[0]}; options=("${options[@]:1}"); fi
asked=${#options[@]}

# given: whether one of these options is among OPTIONS.
given() {
  local name option
  for option in ${options[@]+"${options[@]}"}; do
    for name in "$@"; do [ "${option%%=*}" != "$name" ] || return 0; done
  done
  return 1
}

# Only what the command needs; all backends and libraries, as the Python package has them, if OPTIONS name one.
targets=(roughcontact_command rcb_fft)
case " ${options[*]-}" in *\ --backend* | *\ --solver* | *certify_backend*) targets+=(roughcontact_python) ;; esac
if [ $page = yes ]; then
  python3 -c 'import importlib.util as u, sys; sys.exit(not all(map(u.find_spec, ("jinja2", "numpy", "plotly"))))' ||
    { echo "--page needs packages of Python: pip install jinja2 numpy plotly (Debian: in a venv)" >&2; exit 1; }
  targets+=(roughcontact_request roughcontact_surface)
fi

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
  local target
  [ -e "$build/built" ] || return 1
  for target in "${targets[@]}"; do [[ " $(<"$build/built") " == *" $target "* ]] || return 1; done
  [ -z "$(find "$root"/{CMakeLists.txt,CMakePresets.json,backends,bindings,cmake,flow,formats,include,mpi,packaging,pkgconfig,request,src,surface,tools} -newer "$build/built" -print -quit)" ]
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

demo=no
given --approach --load --pressure --area && pressed=yes || pressed=no
given --modulus --E --nu && elastic=yes || elastic=no
if [ -z "$surface" ]; then
  surface=$build/demo/steel.gsf
  if [ ! -e "$surface" ] || [ "$build/bin/roughcontact" -nt "$surface" ]; then
    mkdir -p "$build/demo"
    "$build/bin/roughcontact" generate spectral --output "$surface" --size 512 --pitch 1um --rolloff 128um --shortest 8um --rms-slope 0.05
  fi
  [ "$asked" -gt 0 ] || demo=yes
  [ $elastic = yes ] || options+=(--E 10MPa --nu 0.5)
  [ $pressed = yes ] || options+=(--pressure '20kPa,50kPa,100kPa')
else
  given --remove || options+=(--remove plane)
  [ $elastic = yes ] || options+=(--modulus 1e11)
  [ $pressed = yes ] || options+=(--pressure '5e7,5e8,2e9')
  case $surface in
    *.npy | *.txt | *.csv | *.tsv | *.dat | *.asc | *.xyz) given --unit || options+=(--unit um) ;;
  esac
  case $surface in
    *.npy | *.txt | *.csv | *.tsv | *.dat | *.asc) given --pitch || options+=(--pitch 1) ;;
  esac
fi
given --out || options+=(--out "$build/demo/out")
for ((i = 0; i < ${#options[@]}; ++i)); do
  case ${options[i]} in
    --out) out=${options[i + 1]-} ;;
    --out=*) out=${options[i]#--out=} ;;
  esac
done

status=0
"$build/bin/roughcontact" solve "$surface" "${options[@]}" || status=$?
[ $status = 0 ] || [ $status = 2 ] || exit $status
for picture in "$out"/{contact-*,history}.png; do
  [ ! -e "$picture" ] || echo "picture: $picture"
done

if [ $page = yes ]; then
  PYTHONPATH=$root/bindings/python ROUGHCONTACT_LIBRARY=$build/lib/libroughcontact.so \
    python3 -m roughcontact report "$out" --out "$out/report.html" >/dev/null || [ $? = 2 ] || exit 1
  echo "page: $out/report.html"
else
  echo "For an HTML report: the same with --page"
fi
if [ $demo = yes ] && [ $status = 0 ]; then
  echo "How much of a rubber seal (E = 10 MPa) touches lapped steel (rms height 0.45 um)? Adhesion, which would add some, is left out:"
  awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) { name = $i; sub(/ \[.*/, "", name); at[name] = i } }
    NR > 1 { answer = answer (NR > 2 ? ", " : "") sprintf("%.3g %% under %g kPa", 100 * $at["area_fraction"], $at["mean_pressure"] / 1000)
      largest = $at["max_pressure"] / 1e6 }
    END { printf "%s; the largest pressure is %.2g MPa.\n", answer, largest }' "$out/steps.csv"
fi
exit $status
