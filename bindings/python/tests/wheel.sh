#!/usr/bin/env bash
# wheel.sh SOURCE PYTHON: builds the wheel, which compiles the library, installs it in a clean virtual environment with NumPy and pytest
# alone, and runs the tests against it. Exits with 77 where pip cannot get what it needs.
set -euo pipefail
source=$1 python=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset PYTHONPATH ROUGHCONTACT_LIBRARY RC_PLUGIN_PATH

skip() { echo "skipped: $*"; exit 77; }

"$python" -m venv "$scratch/build" >/dev/null 2>&1 || skip "$python has no venv (Debian: python3-venv)"
"$scratch/build/bin/pip" install -q "scikit-build-core>=0.10" >"$scratch/log" 2>&1 || skip "pip cannot get scikit-build-core: $(tail -1 "$scratch/log")"
"$python" -m venv "$scratch/clean"
"$scratch/clean/bin/pip" install -q "numpy>=1.21" "pytest>=7" >"$scratch/log" 2>&1 || skip "pip cannot get numpy and pytest: $(tail -1 "$scratch/log")"

# pip copies nothing: what it builds is the tree's tracked files, in a folder of their own.
mkdir "$scratch/source"
(cd "$source" && { git ls-files -z --cached --others --exclude-standard 2>/dev/null || find . -type f -not -path './build*' -print0; } |
  tar --null -T - -c --ignore-failed-read 2>/dev/null) | tar -x -C "$scratch/source"
start=$SECONDS
"$scratch/build/bin/pip" wheel -q --no-deps --no-build-isolation -w "$scratch" "$scratch/source" || { echo "FAILED: pip wheel"; exit 1; }
wheel=$(echo "$scratch"/roughcontact-*.whl)
echo "built $(basename "$wheel") in $((SECONDS - start)) s, $(stat -c %s "$wheel") bytes"
case $(basename "$wheel") in
  roughcontact-*-py3-none-linux_*.whl) ;;
  *) echo "FAILED: the wheel's tag is not py3-none-linux_*"; exit 1 ;;
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
print("installed, with", ", ".join(names))
END
PYTHONDONTWRITEBYTECODE=1 "$source/bindings/python/tests/run.sh" "$scratch/clean/bin/python" -c "$source/pyproject.toml" -m "not slow" "$source/bindings/python/tests"
