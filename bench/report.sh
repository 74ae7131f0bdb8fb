#!/usr/bin/env bash
# report.sh BUILD [SURFACE]: runs the benchmarks of a finished build that are no matter of size, and renews bench/results, docs/images
# and the tables of docs/benchmarks.md, docs/failures.md and docs/physics.md. SURFACE: a measured surface for the failure atlas.
# performance.sh does the same for docs/performance.md, paper.sh for docs/paper.md, pareto.sh for
# docs/speed-accuracy.md.
set -euo pipefail
build=$(cd "${1:?usage: report.sh BUILD [SURFACE]}" && pwd)
surface=${2:+$(realpath "$2")}
cd "$(dirname "$0")/.."
export PYTHONDONTWRITEBYTECODE=1
mkdir -p bench/results
"$build/bin/roughcontact-bench" products --json bench/results/products.json
"$build/bin/roughcontact-bench" failures ${surface:+--surface "$surface"} --json bench/results/failures.json
"$build/bin/roughcontact-bench" histories --seeds 1,2 --json bench/results/histories.json
"$build/bin/roughcontact-bench" physics --json bench/results/physics.json
python3 bench/charts.py bench/results docs/images failures
python3 bench/tables.py bench/results docs/benchmarks.md
python3 bench/failure_tables.py bench/results docs/failures.md
python3 bench/physics.py bench/results docs/images docs/physics.md
