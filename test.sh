#!/usr/bin/env bash
# ./test.sh [--quick | --full] [PART...]: installs what is missing, then builds and tests. Ends with the time of each stage, the ten
# slowest tests, and "N passed, N failed, N skipped".
#   --quick  before each commit: checks of the source, gcc without benchmarks, reduced tests of what changed (scripts/affected.py)
#   (none)   what CI runs: checks of the source, gcc, checks of the binaries, a smoke test of other systems, address, undefined
#            behaviour and thread sanitizers where they tell most
#   --full   before a release: all sizes, measured surfaces where they are, the tests on other systems, every family under the
#            sanitizers, clang, clang-tidy, fuzzing, mutants. Called again on the same commit, it runs only what has not passed yet.
#   PART     these stages only, of all but --quick: source, gcc, systems, asan, tsan, and with --full more
set -euo pipefail
cd "$(dirname "$0")"
tier='' parts=()
for each in "$@"; do
  case $each in
    --quick | --full) tier=$each ;;
    source | gcc | systems | asan | tsan | more) parts+=("$each") ;;
    *) sed -n '2,9s/^# //p' "$0"; exit 2 ;;
  esac
done
passed=0 failed=0 skipped=0
times=$(mktemp)
trap 'rm -f "$times"' EXIT
jobs=$(nproc)  # before OMP_THREAD_LIMIT is set, which it obeys
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$jobs}

full() { [ "$tier" = --full ]; }
quick() { [ "$tier" = --quick ]; }
wanted() { [ ${#parts[@]} = 0 ] || [[ " ${parts[*]} " == *" $1 "* ]]; }

# state: the tree of the commit, if nothing differs from it.
state() { [ -n "$(git status --porcelain 2>&1)" ] || git rev-parse 'HEAD^{tree}'; }
# The result of --full on this tree; scripts/release.sh asks for its last line.
record=build-gcc/full-test
note() { ! full || [ -z "$tree" ] || [ "$(state)" != "$tree" ] || echo "$tree $*" >>"$record"; }

# stage NAME COMMAND...: with --full, a stage that has passed on this tree is not run again.
stage() {
  local start=$SECONDS before=("$passed" "$failed" "$skipped") counts
  echo
  if full && read -ra counts < <(sed -n "s/^$tree passed $1: \\([0-9]* [0-9]*\\)$/\\1/p" "$record" 2>/dev/null); then
    echo "== $1: has passed on this tree"
    passed=$((passed + counts[0])) skipped=$((skipped + counts[1]))
    return
  fi
  echo "== $1 ($((SECONDS / 60)) min)"
  "${@:2}"
  printf '%5d s  %s\n' $((SECONDS - start)) "$1" >>"$times"
  [ "$failed" != "${before[1]}" ] || note "passed $1: $((passed - before[0])) $((skipped - before[2]))"
}

check() {
  local code=0
  "$@" || code=$?
  case $code in 0) passed=$((passed + 1)) ;; 77) skipped=$((skipped + 1)) ;; *) failed=$((failed + 1)) ;; esac
}

# build PRESET [cmake options] [--target=TARGET...]: quietly.
build() {
  local log=build-$1.log each options=() targets=()
  for each in "${@:2}"; do
    case $each in --target=*) targets+=(--target "${each#*=}") ;; *) options+=("$each") ;; esac
  done
  if { cmake --preset "$1" "${options[@]}" && cmake --build "build-$1" -j "$jobs" "${targets[@]}"; } >"$log" 2>&1; then
    mv "$log" "build-$1/build.log"
  else
    grep -E -m 20 "error|Error" "$log" || tail -20 "$log"
    echo "does not build: $log"
    return 1
  fi
}

# run_tests PRESET [ctest options]: only what is wrong is shown.
run_tests() {
  local log=build-$1/ctest.log ok=0 good lost=0 left
  ctest --test-dir "build-$1" --output-on-failure --no-tests=error --timeout 600 "${@:2}" >"$log" 2>&1 || ok=$?
  good=$(grep -acE '^ *[0-9]+/[0-9]+ Test .* Passed ' "$log" || true)
  left=$(grep -acE '^ *[0-9]+/[0-9]+ Test .*\*\*\*Skipped' "$log" || true)
  if [ $ok != 0 ]; then
    lost=$(grep -aE '^ *[0-9]+/[0-9]+ Test .*\*\*\*' "$log" | grep -avc '\*\*\*Skipped' || true)
    [ "$lost" -gt 0 ] || lost=1
    grep -avE '^\[ +(OK|RUN) +\]|^ *Start +[0-9]+:| Passed +[0-9.]+ sec|^Errors while' "$log" || true
  else
    grep -aE '\*\*\*Skipped' "$log" || true
  fi
  echo "$good passed, $lost failed, $left skipped"
  passed=$((passed + good)) failed=$((failed + lost)) skipped=$((skipped + left))
  cp "$log" "build-$1/ctest-$SECONDS.log"
  [ "$1" != gcc ] || check .ci/skipped.sh "$log"
}

# verify PRESET "CMAKE OPTIONS" [ctest options]
verify() {
  local options
  read -ra options <<<"$2"
  if build "$1" "${options[@]}"; then run_tests "$1" "${@:3}"; else failed=$((failed + 1)); fi
}

echo "== packages"
[ "${parts[*]-}" = source ] || scripts/bootstrap.sh --tests
tree=$(state)  # git is there now
# An empty tree takes the faster generator, and a compiler cache where there is one.
! command -v ninja >/dev/null || export CMAKE_GENERATOR=${CMAKE_GENERATOR-Ninja}
if command -v ccache >/dev/null; then
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
  export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1  # what another clone has compiled serves this one
  export CCACHE_SLOPPINESS=pch_defines,time_macros  # else it leaves out what includes precompiled headers
fi
rm -f build-*/ctest-*.log

# The tests of what changed, and of the build only what they need. The commands of pages are slow and the only tests of these: if pages
# alone have changed, theirs run instead of docs.commands.
quick_tests() {
  local folder what labels except names=() folders=() pages=() said
  said=$(scripts/affected.py) || { failed=$((failed + 1)); return; }  # before there is a log, which would be a new file
  echo "${said//$'\n'/, }"
  cmake --preset gcc -DRC_BUILD_BENCH=OFF >build-gcc.log 2>&1 || { tail -20 build-gcc.log; failed=$((failed + 1)); return; }
  while read -r folder what; do
    labels='slow|full' except='^$'
    folders+=("$folder")
    case $folder in
      contract/pairs) [ -z "$what" ] || export RC_TEST_SOLVER=$what ;;
      outside/docs)
        labels=full
        [ -z "$what" ] || { read -ra pages <<<"$what" && except='docs\.(commands|reference)'; }
        ;;
    esac
    mapfile -t -O ${#names[@]} names < <(ctest --test-dir "build-gcc/tests/$folder" -N -LE "$labels" -E "$except" | sed -nE 's/^ *Test +#[0-9]+: //p')
  done <<<"$said"
  # shellcheck disable=SC2046
  build gcc -DRC_BUILD_BENCH=OFF $(quick_targets "${folders[@]}") || { failed=$((failed + 1)); return; }
  [ ${#names[@]} = 0 ] || run_tests gcc -R "^($(IFS='|'; echo "${names[*]}"))\$"
  [ ${#pages[@]} = 0 ] || check "$(sed -n "s/^RC_TEST_PYTHON:FILEPATH=//p" build-gcc/CMakeCache.txt)" -B tests/outside/docs/commands.py build-gcc "${pages[@]}"
}
# quick_targets FOLDER...: options for build(): the product and these folders below tests/; none: everything.
quick_targets() {
  [ -e build-gcc/build.ninja ] && [ "$*" != . ] || return 0
  ninja -C build-gcc -t targets all | sed -nE 's,^(.*/all): phony$,\1,p' | grep -vE '^(tests|bench|fuzz|examples)/' | sed 's/^/--target=/'
  printf -- '--target=tests/%s/all\n' "$@"
}
gcc_build() { build gcc -DRC_BUILD_BENCH=ON || failed=$((failed + 1)); }
source_checks() {
  check .ci/include_graph.py
  check .ci/platforms.py
  check .ci/batches.py
  check .ci/constants.py
  check .ci/format.sh
}
binary_checks() {
  check .ci/globals.sh build-gcc
  check .ci/no_side_effects.sh build-gcc
}
other_systems() {
  local how=--smoke
  ! full || how=--test
  check packaging/cross.sh $how all
  ! full || check packaging/cross.sh --smoke i686  # 32 bits
}
asan() {
  local families="" but=(-E 'failures|pairs\.analytic')
  if ! full; then
    families="behaviour/batch behaviour/device behaviour/formats behaviour/honesty behaviour/threads contract/backends contract/errors"
    families+=" contract/options contract/plugins behaviour/law behaviour/product faults/process scenes"
    but=()
  fi
  RC_TEST_QUICK=1 verify asan "-DRC_TEST_FAMILIES=${families// /;}" -LE 'slow|full' "${but[@]}"
}
# Loops that a library spreads with OpenMP wait in a runtime that the sanitizer cannot see into: one thread for those.
tsan() { OMP_THREAD_LIMIT=1 RC_TEST_QUICK=1 verify tsan "" -R 'threads|contract\.'; }
mutants() { if build mutants; then check scripts/mutants.py build-mutants --jobs "$jobs"; else failed=$((failed + 1)); fi; }

! wanted source || stage "checks of the source" source_checks
if quick; then
  RC_TEST_QUICK=1 stage "gcc, reduced tests of what changed" quick_tests
else
  if wanted gcc; then
    stage "gcc: build" gcc_build
    if full; then stage "gcc: tests" run_tests gcc; else stage "gcc: tests" run_tests gcc -LE full; fi
    stage "checks of the binaries" binary_checks
  fi
  ! wanted systems || stage "other systems" other_systems
  ! wanted asan || stage "clang: address and undefined behaviour sanitizers" asan
  ! wanted tsan || stage "gcc: thread sanitizer" tsan
fi
if full && wanted more; then
  stage "clang" check build clang
  stage "clang-tidy" check .ci/tidy.sh build-clang
  stage "fuzzing, a minute each" verify fuzz "" -L full
  stage "mutants of the certificate and the bounds" mutants
fi

echo
cat "$times"
echo "slowest:"
{ cat build-*/ctest-*.log 2>/dev/null || true; } | sed -nE 's|^ *[0-9]+/[0-9]+ Test +#[0-9]+: ([^ ]+) .* ([0-9.]+) sec$|\2 s  \1|p' | sort -rn | sed -n 1,10p
echo
echo "$passed passed, $failed failed, $skipped skipped"
[ ${#parts[@]} != 0 ] || note "$(date -u +%F): $passed passed, $failed failed, $skipped skipped"
[ $failed = 0 ]
