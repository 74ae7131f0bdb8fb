#!/usr/bin/env bash
# wheel.sh SOURCE PYTHON CC CXX WERROR: makes the source distribution and the wheel as packaging/wheel.sh does, installs the wheel in a
# clean virtual environment with NumPy and pytest alone, and runs the tests against it; then in a bare system, where that can be
# made. Exits with 77 where pip cannot get what it needs. Compilers and flags are those of the build around it.
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
wheel=$(echo "$scratch"/dist/roughcontact-*.whl)
echo "built $(basename "$wheel") in $((SECONDS - start)) s, $(stat -c %s "$wheel") bytes"
case $(basename "$wheel") in
  roughcontact-*-py3-none-manylinux_*.whl) ;;
  *) fail "the wheel's tag is not py3-none-manylinux_*" ;;
esac
# What the source distribution is for: all that is compiled, and its tests; no build trees, no data of benchmarks.
tar -tzf "$scratch"/dist/roughcontact-*.tar.gz >"$scratch/names"
for name in LICENSE CITATION.cff CMakeLists.txt include/roughcontact/roughcontact.h packaging/wheel.sh tests/outside/python/conftest.py; do
  grep -q "/$name$" "$scratch/names" || fail "the source distribution has no $name"
done
! grep -E '^[^/]*/(build|bench|fuzz)' "$scratch/names" | head -3 | grep . || fail "the source distribution has too much"

"$scratch/clean/bin/pip" install -q --no-deps "$wheel"
cd "$scratch/clean"
"$scratch/clean/bin/python" - <<'END'
import importlib.metadata
import pathlib
import roughcontact as rc

package = pathlib.Path(rc.__file__).parent
assert pathlib.Path(rc.library_file()).parent == package / "lib", rc.library_file()
assert importlib.metadata.version("roughcontact") == rc.__version__ == ".".join(map(str, rc.version()))
names = {each.name: each.origin for each in rc.backends()}
assert {"dense", "fft", "split"} <= names.keys(), names
assert all(origin == "built-in" or origin.startswith(str(package)) for origin in names.values()), names
rc.surface.noise((4, 4)), rc.formats(), rc.flow([[1, 1]], pitch=1, viscosity=1, pressure_drop=1)
with open("/proc/self/maps") as maps:
    carried = {line.split()[-1] for line in maps if any(f"lib{name}" in line for name in ("fftw", "gsl", "cholmod", "zip", "pugixml"))}
assert carried and all(file.startswith(str(package.parent)) for file in carried), carried
assert (package / "py.typed").exists() and not list(package.rglob("*.h")) and not list(package.rglob("*.a"))
for file in package.rglob("*.so*"):
    assert b"/tmp/" not in file.read_bytes(), f"{file} names a temporary folder"
print("installed, with", ", ".join(names))
END
for command in "$scratch/clean/bin/roughcontact" "$scratch/clean/bin/python -m roughcontact"; do
  $command generate spectral --help >"$scratch/log" 2>&1 || fail "$command: $(tail -1 "$scratch/log")"
  $command backends | grep -q "^fft " || fail "$command knows no plugin"
done
PYTHONDONTWRITEBYTECODE=1 "$source/tests/outside/python/run.sh" "$scratch/clean/bin/python" -c "$source/pyproject.toml" \
  -m "not slow" "$source/tests/outside/python"
status=0
"$source/packaging/bare.sh" "$wheel" || status=$?
[ $status = 0 ] || [ $status = 77 ] || exit $status
