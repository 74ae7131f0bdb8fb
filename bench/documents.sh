#!/usr/bin/env bash
# documents.sh [--quick]: on a fresh clone, installs what is missing, builds into build/, and measures anew what docs/speed-accuracy.md,
# docs/paper.md and docs/physics.md say and show, about an hour on one core; what the same library has measured is not measured again.
# --quick: small scenes, into build/ instead of the source tree, three minutes beside the build.
set -euo pipefail
cd "$(dirname "$0")/.."
quick=()
[ "${1:-}" != --quick ] || quick=(--quick)
scripts/bootstrap.sh
mkdir -p build
log=build/build.log
echo "building in build"
{ cmake --preset release && cmake --build build -j "$(nproc)" --target roughcontact-bench rcb_fft rcb_split rcb_cholmod; } >"$log" 2>&1 ||
  { tail -30 "$log"; echo "the build failed: $log"; exit 1; }
bench/pareto.sh build "${quick[@]}" --threads 1
bench/paper.sh build "${quick[@]}" --threads 1
if [ ${#quick[@]} = 0 ]; then
  build/bin/roughcontact-bench physics --threads 1 --json bench/results/physics.json
  PYTHONDONTWRITEBYTECODE=1 python3 bench/physics.py bench/results docs/images docs/physics.md
else
  build/bin/roughcontact-bench physics --quick --threads 1
fi
