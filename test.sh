#!/usr/bin/env bash
# ./test.sh [--quick]: installs what is missing, then builds and runs every test: gcc, clang with sanitizers, checks of the source.
# --quick: the tests with gcc only. Ends with "N passed, N failed".
set -euo pipefail
cd "$(dirname "$0")"
quick=${1:-}
passed=0 failed=0

stage() { echo; echo "== $* ($((SECONDS / 60)) min)"; }
count() { if [ "$1" = 0 ]; then passed=$((passed + 1)); else failed=$((failed + 1)); fi; }

# build PRESET: all of it, quietly.
build() {
  local log=build-$1.log
  if { cmake --preset "$1" && cmake --build "build-$1" -j "$(nproc)"; } >"$log" 2>&1; then
    mv "$log" "build-$1/build.log"
  else
    grep -E -m 20 "error|Error" "$log" || tail -20 "$log"
    echo "does not build: $log"
    count 1
    return 1
  fi
}

# run_tests PRESET [ctest options]: only what is wrong is shown.
run_tests() {
  local log=build-$1/ctest.log bad=0 good skipped
  ctest --test-dir "build-$1" --output-on-failure --no-tests=error --timeout 600 -j "$(nproc)" "${@:2}" >"$log" 2>&1 || bad=1
  good=$(grep -cE '^ *[0-9]+/[0-9]+ Test .* Passed ' "$log" || true)
  skipped=$(grep -cE '^ *[0-9]+/[0-9]+ Test .*\*\*\*Skipped' "$log" || true)
  if [ $bad = 1 ]; then
    bad=$(grep -cE '^ *[0-9]+/[0-9]+ Test .*\*\*\*' "$log" || true)
    bad=$((bad > skipped ? bad - skipped : 1))
    grep -vE '^\[ +(OK|RUN) +\]|^ *Start +[0-9]+:| Passed +[0-9.]+ sec|^Errors while' "$log"
  fi
  echo "$good passed, $bad failed, $skipped skipped ($(grep 'Total Test time' "$log" | sed 's/.*= *//'))"
  passed=$((passed + good)) failed=$((failed + bad))
}

check() { local status=0; "$@" || status=$?; count $status; }

stage "packages"
scripts/bootstrap.sh --tests

stage "gcc, warnings are errors"
if build gcc; then run_tests gcc -LE full; fi

if [ "$quick" != --quick ]; then
  stage "source and binary checks"
  check .ci/include_graph.py
  check .ci/format.sh
  check .ci/globals.sh build-gcc
  check .ci/no_side_effects.sh build-gcc

  # Families that only do more of what others do are left to gcc.
  stage "clang, warnings are errors, address and undefined behaviour sanitizers, quick tests"
  if build asan; then
    RC_TEST_QUICK=1 run_tests asan -LE slow -E 'failures|pairs\.(analytic|invariance\.(repetitions|sequences))'
    check .ci/tidy.sh build-asan
  fi

  stage "thread sanitizer, tests with threads"
  # Loops that a library spreads with OpenMP wait in a runtime that the sanitizer cannot see into: one thread for those.
  if build tsan; then OMP_THREAD_LIMIT=1 RC_TEST_QUICK=1 run_tests tsan -R 'threads|seam'; fi
fi

echo
echo "$passed passed, $failed failed"
[ $failed = 0 ]
