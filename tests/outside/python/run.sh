#!/usr/bin/env bash
# run.sh PYTHON ARGUMENT...: pytest with these arguments; exits with 77 where NumPy or pytest is missing.
python=$1
shift
for module in numpy pytest; do
  "$python" -c "import $module" 2>/dev/null || { echo "skipped: $python has no $module (Debian: python3-$module)"; exit 77; }
done
exec "$python" -m pytest -q -p no:cacheprovider "$@"
