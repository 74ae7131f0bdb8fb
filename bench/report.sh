#!/usr/bin/env bash
# report.sh BUILD: runs both benchmarks of a finished build and renews bench/results, docs/images and the tables of
# docs/benchmarks.md.
set -euo pipefail
build=$(cd "${1:?usage: report.sh BUILD}" && pwd)
cd "$(dirname "$0")/.."
export PYTHONDONTWRITEBYTECODE=1
mkdir -p bench/results
"$build/bin/roughcontact-bench" scaling --json bench/results/scaling.json
"$build/bin/roughcontact-bench" accuracy --time-limit 60 --json bench/results/accuracy.json
python3 bench/charts.py bench/results docs/images
python3 bench/tables.py bench/results docs/benchmarks.md
