#!/usr/bin/env bash
# report.sh BUILD [SURFACE]: runs the benchmarks of a finished build that are no matter of size, and renews bench/results, docs/images
# and the tables of docs/benchmarks.md, docs/failures.md and docs/paper.md. SURFACE: a measured surface for the failure atlas.
# performance.sh does the same for docs/performance.md.
set -euo pipefail
build=$(cd "${1:?usage: report.sh BUILD [SURFACE]}" && pwd)
surface=${2:+$(realpath "$2")}
cd "$(dirname "$0")/.."
export PYTHONDONTWRITEBYTECODE=1
mkdir -p bench/results
"$build/bin/roughcontact-bench" products --json bench/results/products.json
"$build/bin/roughcontact-bench" accuracy --time-limit 60 --json bench/results/accuracy.json
"$build/bin/roughcontact-bench" failures ${surface:+--surface "$surface"} --json bench/results/failures.json
"$build/bin/roughcontact-bench" histories --seeds 1,2 --json bench/results/histories.json
printed=nnls+nnls.pivoting=single
"$build/bin/roughcontact-bench" histories --levels 7 --backend dense --json bench/results/paper.json --solvers \
  "polonsky-keer,nnls,$printed,$printed+warmup=gp+warmup.iterations=100,greedy,greedy+greedy.inner=cholesky,admm,gp,cmr,haar-cg"
python3 bench/charts.py bench/results docs/images speed-accuracy failures
python3 bench/tables.py bench/results docs/benchmarks.md
python3 bench/failure_tables.py bench/results docs/failures.md docs/paper.md
