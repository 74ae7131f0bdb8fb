#!/usr/bin/env bash
# installed_wheels.sh SOURCE VENV WHEEL GPL-WHEEL: installs the first wheel in a virtual environment that has NumPy, and uses it alone;
# then the second, and uses both.
set -euo pipefail
source=$(realpath "$1") bin=$(realpath "$2")/bin wheel=$(realpath "$3") gpl=$(realpath "$4")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "FAILED: $*"; exit 1; }
log=$scratch/log
cd "$scratch"
sphere=(generate sphere --radius 1mm --pitch 1um --output sphere.gsf)
"$bin/pip" install -q --no-deps "$wheel"
"$bin/python" -B "$source/tests/outside/python/default_wheel.py" "$source"
example=$("$bin/python" -c 'import pathlib, roughcontact; print(pathlib.Path(roughcontact.__file__).with_name("example.gsf"))')
for command in "$bin/roughcontact" "$bin/python -m roughcontact"; do
  ! $command "${sphere[@]}" >"$log" 2>&1 || fail "generate works without its library"
  grep -q 'pip install roughcontact-gpl' "$log" || fail "$command generate: $(cat "$log")"
  ! $command analyze "$example" >"$log" 2>&1 || fail "analyze works without its library"
  grep -q 'pip install roughcontact-gpl' "$log" || fail "$command analyze: $(cat "$log")"
  $command solve "$example" --E 3GPa --nu 0.4 --pressure 10MPa >"$log" 2>&1 || fail "$command solve: $(cat "$log")"
  $command backends | grep -q "^fft " || fail "$command knows no plugin"
done
"$bin/pip" install -q --no-deps "$gpl"
"$bin/pip" check >"$log" || fail "pip check: $(cat "$log")"
"$bin/python" -B "$source/tests/outside/python/both_wheels.py"
for command in "$bin/roughcontact" "$bin/python -m roughcontact"; do
  $command "${sphere[@]}" >"$log" 2>&1 || fail "$command: $(tail -1 "$log")"
  $command backends | grep -q "^split " || fail "$command knows no plugin"
done
"$bin/pip" uninstall -q -y roughcontact-gpl
$bin/roughcontact backends | grep -q "^fft " || fail "the first does not work after the second is removed"
"$bin/pip" install -q --no-deps "$gpl"
