#!/usr/bin/env bash
# pareto.sh BUILD [--quick] [--surfaces FOLDER] [--threads N] [--time-limit SECONDS] [--scenes A,B] [--contacts 10,1]: measures speed
# against accuracy, and renews bench/results/pareto.json and .csv, docs/images/speed-accuracy.png and pareto-*.png, and the tables of
# docs/speed-accuracy.md. Interrupted and called again it goes on where it stopped: what the same library has measured is not measured
# again. --quick: two scenes on 64², into BUILD/pareto-quick instead of the source tree. FOLDER: measured surfaces, by default
# ../shared/data beside the source tree where that is. Other codes are compared where bench/peers/peers.sh has installed them.
set -euo pipefail
build=$(cd "${1:?usage: pareto.sh BUILD [--quick] [--surfaces FOLDER] [--threads N] [--time-limit SECONDS]}" && pwd)
shift
quick=0 options=() goal_options=() surfaces=
while [ $# -gt 0 ]; do
  case $1 in
    --quick) quick=1 ;;
    --surfaces) surfaces=$(cd "${2:?folder}" && pwd) && shift ;;
    --threads) options+=("$1" "${2:?value of $1}") && goal_options+=("$1" "$2") && shift ;;
    --time-limit | --scenes | --contacts) options+=("$1" "${2:?value of $1}") && shift ;;
    *) echo "pareto.sh: unknown option $1" >&2 && exit 2 ;;
  esac
  shift
done
cd "$(dirname "$0")/.."
export PYTHONDONTWRITEBYTECODE=1
python=${PYTHON:-python3}
results=bench/results images=docs/images page=docs/speed-accuracy.md
[ -n "$surfaces" ] || [ ! -d ../shared/data ] || surfaces=$(cd ../shared/data && pwd)
[ -z "$surfaces" ] || { options+=(--surfaces "$surfaces") && goal_options+=(--surfaces "$surfaces"); }
if [ $quick = 1 ]; then
  options+=(--quick)
  goal_options+=(--scenes hertz,self-affine --points 128 --seeds 2 --contacts 10)
  results=$build/pareto-quick images=$results page=$results/speed-accuracy.md
  mkdir -p "$results"
  cp docs/speed-accuracy.md "$page"
fi
mkdir -p "$results"
exported=$build/pareto-scenes
[ $quick = 0 ] || exported=$results/scenes
"$build/bin/roughcontact-bench" pareto ${options[@]+"${options[@]}"} --json "$results/pareto.json" --csv "$results/pareto.csv" \
  --export "$exported"
"$build/bin/roughcontact-bench" goal ${goal_options[@]+"${goal_options[@]}"} --json "$results/goal.json" >"$results/goal.txt"
environment=${XDG_CACHE_HOME:+$XDG_CACHE_HOME/roughcontact-peers}
peers=${PEERS_PYTHON:-${environment:-$build/peers}/bin/python3}
if [ $quick = 1 ]; then
  echo "other codes are left out"
elif [ -x "$peers" ]; then
  "$peers" bench/pareto_peers.py "$results/pareto.json" "$exported"
else
  echo "no other codes: bench/peers/peers.sh installs them"
fi
if command -v gnuplot >/dev/null; then
  "$python" bench/pareto_charts.py "$results" "$images"
else
  echo "no gnuplot: the charts stay as they are"
fi
"$python" bench/pareto_tables.py "$results" "$page"
echo "written: $page"
