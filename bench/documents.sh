#!/usr/bin/env bash
# documents.sh [--quick]: on a fresh clone, installs what is missing, builds into build/, and measures anew what
# the pages physics.md, speed-accuracy.md and paper.md show, about an hour on one core; what the same library has measured is not
# measured again.
# --quick: small scenes, into build/ instead of the source tree, three minutes beside the build.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/bootstrap.sh
mkdir -p build
log=build/build.log
echo "building in build"
{ cmake --preset release && cmake --build build -j "$(nproc)" --target roughcontact-bench rcb_fft rcb_split rcb_cholmod; } >"$log" 2>&1 ||
  { tail -30 "$log"; echo "the build failed: $log"; exit 1; }
build/bin/roughcontact-bench documents speed-accuracy paper physics --threads 1 "$@"
