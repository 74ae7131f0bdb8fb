#!/usr/bin/env bash
# performance.sh BUILD [--quick] [--budget MINUTES]: runs the benchmarks behind docs/performance.md, the most important first, and renews
# bench/results, docs/images/scaling.png and the tables of the page. Called again it goes on where it stopped: what the same library
# has measured is not measured again. --budget: no benchmark begins after so many minutes. --quick: small sizes, in less than a
# minute, into BUILD/performance-quick instead of the source tree.
set -euo pipefail
build=$(cd "${1:?usage: performance.sh BUILD [--quick] [--budget MINUTES]}" && pwd)
shift
quick=0 budget=100000
while [ $# -gt 0 ]; do
  case $1 in
    --quick) quick=1 ;;
    --budget) budget=${2:?minutes} && shift ;;
    *) echo "performance.sh: unknown option $1" >&2 && exit 2 ;;
  esac
  shift
done
cd "$(dirname "$0")/.."
export PYTHONDONTWRITEBYTECODE=1
python=${PYTHON:-python3}
bench=$build/bin/roughcontact-bench
results=bench/results images=docs/images page=docs/performance.md
if [ $quick = 1 ]; then
  results=$build/performance-quick images=$results page=$results/performance.md
  mkdir -p "$results"
  cp docs/performance.md "$page"
fi
field() { sed -n 's/^ *"library": "\([0-9a-z]*\)",*$/\1/p' "$@" | head -n 1; }
library=$("$bench" provenance | field)
left() { awk -v budget="$budget" -v spent="$SECONDS" 'BEGIN { printf "%d", budget * 60 - spent }'; }
up() { [ "$(left)" -le 0 ] && echo "the budget is spent: $* is left out"; }

# rows OPTIONS...: rows of the scaling table, each kept as soon as it is there.
rows() {
  if up "scaling $*"; then return; fi
  echo "== scaling $*"
  "$bench" scaling --time-limit "$(left)" --json "$results/scaling.json" "$@"
}

# once NAME COMMAND...: results that are written whole, unless this library has them.
once() {
  local name=$1 file=$results/$1.json
  shift
  if [ -e "$file" ] && grep -q "\"library\": \"$library\"" "$file"; then
    echo "== $name: measured before"
  elif ! up "$name"; then
    echo "== $name"
    "$@" --json "$file"
  fi
}

if [ $quick = 1 ]; then
  rows --sizes 128,256 --percents 0.1,10 --budget 0
  once products "$bench" products --quick --sizes 128
  once limits "$bench" limits --quick --sizes 128
  once busy "$bench" busy --quick --points 128
  once deterministic "$bench" deterministic --quick --points 128
  once batch "$bench" batch --quick --surfaces 5 --points 32 --steps 3
  once dilute "$bench" dilute --sizes 256 --contacts 1 --threads 1 --budget 0
else
  rows --sizes 128,256,512,1024,2048,4096 --percents 10,0.1,1,40
  once busy "$bench" busy
  once deterministic "$bench" deterministic
  once products "$bench" products --sizes 512,1024,2048,4096
  once limits "$bench" limits
  once dilute "$bench" dilute
  if "$bench" scaling --sizes 128 --percents 10 --precision single --tol 1e-4 --budget 0 >/dev/null 2>&1; then
    rows --sizes 1024,2048,4096,8192,16384 --percents 0.04,10 --controls load --precision single --tol 1e-4 --budget 0
  else
    echo "this library has no option fft.precision: no rows in single precision"
  fi
  once batch "$bench" batch
  once profile "$python" bench/profile.py "$build"
  rows --sizes 8192,16384 --percents 0.1,10 --controls load --budget 0
  if ! up "peers"; then
    echo "== peers: the standard method"
    bench/peers/peers.sh "$build" --only ours,baseline --sizes 512,1024,2048,4096 --percents 10 --budget "$(($(left) / 60))" ||
      echo "bench/peers/peers.sh failed: the standard method is not compared"
  fi
fi
if command -v gnuplot >/dev/null; then
  "$python" bench/charts.py "$results" "$images" scaling
else
  echo "no gnuplot: the charts stay as they are"
fi
"$python" bench/performance.py "$results" "$page"
echo "written: $page"
