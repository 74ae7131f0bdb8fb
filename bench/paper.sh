#!/usr/bin/env bash
# paper.sh BUILD [--quick] [--figures 2,4,5,6,8,9,10] [--surfaces FOLDER] [--threads N]: measures the figures of Bemporad & Paggi (2015)
# anew, the short ones first, and renews bench/results/paper.json, docs/images/paper-figure-*.png and the tables of docs/paper.md.
# Interrupted and called again it goes on where it stopped: what the same library has measured is not measured again. --quick: small
# grids and few seeds, into BUILD/paper-quick instead of the source tree. FOLDER: measured surfaces for figures 10 and 11, by
# default ../shared/data beside the source tree where that is.
set -euo pipefail
build=$(cd "${1:?usage: paper.sh BUILD [--quick] [--figures N,N] [--surfaces FOLDER] [--threads N]}" && pwd)
shift
quick=0 options=() surfaces=
while [ $# -gt 0 ]; do
  case $1 in
    --quick) quick=1 ;;
    --figures) options+=(--figure "${2:?figures}") && shift ;;
    --threads) options+=(--threads "${2:?threads}") && shift ;;
    --surfaces) surfaces=$(cd "${2:?folder}" && pwd) && shift ;;
    *) echo "paper.sh: unknown option $1" >&2 && exit 2 ;;
  esac
  shift
done
cd "$(dirname "$0")/.."
export PYTHONDONTWRITEBYTECODE=1
python=${PYTHON:-python3}
results=bench/results images=docs/images page=docs/paper.md
[ -n "$surfaces" ] || [ ! -d ../shared/data ] || surfaces=$(cd ../shared/data && pwd)
[ -z "$surfaces" ] || options+=(--surfaces "$surfaces")
if [ $quick = 1 ]; then
  options+=(--quick)
  results=$build/paper-quick images=$results page=$results/paper.md
  mkdir -p "$results"
  cp docs/paper.md "$page"
fi
mkdir -p "$results"
"$build/bin/roughcontact-bench" paper "${options[@]}" --json "$results/paper.json"
if command -v gnuplot >/dev/null; then
  "$python" bench/paper_figures.py "$results" "$images"
else
  echo "no gnuplot: the pictures stay as they are"
fi
"$python" bench/paper_tables.py "$results" "$page"
echo "written: $page"
