#!/usr/bin/env bash
# packaging/bare.sh WHEEL GPL-WHEEL: installs both wheels, with NumPy alone, into a clean system of this release of Debian that has Python
# and no other library, and uses them there: every backend, a surface that is made, one that is read. Needs root, debootstrap, a mirror of
# Debian, and pip's network for NumPy; exit code 77 without. Some minutes.
set -euo pipefail
[ $# = 2 ] || { echo "usage: $0 WHEEL GPL-WHEEL"; exit 1; }
wheels=("$(realpath "$1")" "$(realpath "$2")")
. "$(dirname "$0")/clean_system.sh"
clean_system python3-venv
mount -t proc proc "$root/proc"  # the loader asks it where a program lies

version=$(inside python3 -c 'import sys; print("%d.%d" % sys.version_info[:2])')
mkdir "$root/wheels"
cp "${wheels[@]}" "$root/wheels"
python3 -m pip download -q --only-binary=:all: --python-version "$version" -d "$root/wheels" "numpy>=1.21" >"$root.log" 2>&1 ||
  skip "pip cannot get NumPy: $(tail -1 "$root.log")"
left=$(inside find / -xdev \( -name 'libfftw*' -o -name 'libgsl*' -o -name 'libcholmod*' -o -name 'libzip*' -o -name 'libpugixml*' \))
[ -z "$left" ] || fail "not a bare system: $left"
quietly inside python3 -m venv /venv
quietly inside /venv/bin/pip install --no-index --find-links /wheels roughcontact-gpl
cp "$source/packaging/bare.py" "$source/fuzz/corpus/archive/x3p_valid" "$root/root"
inside /venv/bin/roughcontact backends | grep -q "^fft " || fail "the command does not work"
inside /venv/bin/python /root/bare.py /root/x3p_valid dense fft split cholmod
echo "the wheels work beside Python and NumPy alone"
