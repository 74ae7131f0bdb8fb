#!/usr/bin/env bash
# wheel.sh SOURCE PYTHON CC CXX WERROR: makes the source distribution and the wheels as packaging/wheel.sh does, installs the default one
# in a clean virtual environment with NumPy and pytest alone, uses it there, adds roughcontact-gpl, and runs the tests against both; then
# in a bare system, where that can be made. Exits with 77 where pip cannot get what it needs. Compilers and flags are those of the build around it.
set -euo pipefail
source=$1 python=$2 werror=$5
export CC=$3 CXX=$4 CMAKE_GENERATOR="Unix Makefiles" PYTHON=$python
# Folders stand elsewhere each time; a compiler cache in the environment is to serve nevertheless.
export CCACHE_BASEDIR=/ CCACHE_NOHASHDIR=1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset PYTHONPATH ROUGHCONTACT_LIBRARY RC_PLUGIN_PATH

skip() { echo "skipped: $*"; exit 77; }
fail() { echo "FAILED: $*"; exit 1; }

"$python" -m venv "$scratch/clean" >"$scratch/log" 2>&1 || skip "$python makes no virtual environment (Debian: python3-venv)"
"$scratch/clean/bin/pip" install -q "numpy>=1.21" "pytest>=7" >"$scratch/log" 2>&1 || skip "pip: $(tail -1 "$scratch/log")"
start=$SECONDS
"$source/packaging/wheel.sh" "$scratch/dist" "cmake.define.RC_WERROR=$werror" >"$scratch/log" 2>&1 || {
  status=$?
  tail -40 "$scratch/log"
  exit $status
}
wheel=$(echo "$scratch"/dist/roughcontact-*.whl) gpl=$(echo "$scratch"/dist/roughcontact_gpl-*.whl)
echo "built in $((SECONDS - start)) s"
"$source/tests/outside/python/wheel_files.sh" "$source" "$python" "$wheel" "$gpl"
# What the source distribution is for: all that is compiled, and its tests; no build trees, no data of benchmarks.
tar -tzf "$scratch"/dist/roughcontact-*.tar.gz >"$scratch/names"
for name in LICENSE CITATION.cff CMakeLists.txt include/roughcontact/roughcontact.h packaging/wheel.sh tests/outside/python/conftest.py; do
  grep -q "/$name$" "$scratch/names" || fail "the source distribution has no $name"
done
! grep -E '^[^/]*/(build|bench|fuzz)' "$scratch/names" | head -3 | grep . || fail "the source distribution has too much"

"$source/tests/outside/python/installed_wheels.sh" "$source" "$scratch/clean" "$wheel" "$gpl"
cd "$scratch/clean"
PYTHONDONTWRITEBYTECODE=1 "$source/tests/outside/python/run.sh" "$scratch/clean/bin/python" -c "$source/pyproject.toml" \
  -m "not slow" "$source/tests/outside/python"
status=0
"$source/packaging/bare.sh" "$wheel" "$gpl" || status=$?
[ $status = 0 ] || [ $status = 77 ] || exit $status
