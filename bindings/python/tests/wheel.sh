#!/usr/bin/env bash
# wheel.sh SOURCE PYTHON CC CXX WERROR: builds the wheel, which compiles the library, installs it in a clean virtual environment with
# NumPy and pytest alone, and runs the tests against it. Exits with 77 where pip cannot get what it needs. Compilers and flags are
# those of the build around it, and folders stand as there, so that a compiler cache in the environment serves.
set -euo pipefail
source=$1 python=$2 cc=$3 cxx=$4 werror=$5
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset PYTHONPATH ROUGHCONTACT_LIBRARY RC_PLUGIN_PATH

skip() { echo "skipped: $*"; exit 77; }
fail() { echo "FAILED: $*"; exit 1; }

# environment NAME PACKAGE...
environment() {
  "$python" -m venv "$scratch/$1" >"$scratch/log" 2>&1 || skip "$python makes no virtual environment (Debian: python3-venv)"
  "$scratch/$1/bin/pip" install -q "${@:2}" >"$scratch/log" 2>&1 || skip "pip cannot get ${*:2}: $(tail -1 "$scratch/log")"
}
environment build "scikit-build-core>=0.10"
environment clean "numpy>=1.21" "pytest>=7"

# What git knows, in a folder of its own: no build trees.
mkdir "$scratch/source"
cd "$source"
if git rev-parse --git-dir >/dev/null 2>&1; then
  git ls-files -z --cached --others --exclude-standard
else
  find . -type f -not -path './build*' -print0
fi | tar --null -T - -c --ignore-failed-read 2>/dev/null | tar -x -C "$scratch/source"

start=$SECONDS
export CC=$cc CXX=$cxx CMAKE_GENERATOR="Unix Makefiles"
"$scratch/build/bin/pip" wheel -q --no-deps --no-build-isolation -w "$scratch" --config-settings=build-dir=build \
  --config-settings=cmake.define.RC_WERROR="$werror" "$scratch/source" || fail "pip wheel"
wheel=$(echo "$scratch"/roughcontact-*.whl)
echo "built $(basename "$wheel") in $((SECONDS - start)) s, $(stat -c %s "$wheel") bytes"
case $(basename "$wheel") in
  roughcontact-*-py3-none-linux_*.whl) ;;
  *) fail "the wheel's tag is not py3-none-linux_*" ;;
esac

"$scratch/clean/bin/pip" install -q --no-deps "$wheel"
cd "$scratch/clean"
"$scratch/clean/bin/python" - <<'END'
import pathlib
import roughcontact as rc

package = pathlib.Path(rc.__file__).parent
assert pathlib.Path(rc.library_file()).parent == package / "lib", rc.library_file()
names = {each.name: each.origin for each in rc.backends()}
assert {"dense", "fft", "split"} <= names.keys(), names
assert all(origin == "built-in" or origin.startswith(str(package)) for origin in names.values()), names
assert (package / "py.typed").exists() and not list(package.rglob("*.h")) and not list(package.rglob("*.a"))
for file in package.rglob("*.so*"):
    assert b"/tmp/" not in file.read_bytes(), f"{file} names a temporary folder"
print("installed, with", ", ".join(names))
END
PYTHONDONTWRITEBYTECODE=1 "$source/bindings/python/tests/run.sh" "$scratch/clean/bin/python" -c "$source/pyproject.toml" \
  -m "not slow" "$source/bindings/python/tests"
