#!/usr/bin/env bash
# peers.sh BUILD [--quick] [options of peers.py]: installs the peers into a virtual environment, compares, and renews
# bench/results/peers.json, docs/images/peers-*.png and the tables of docs/peers.md. Called again it goes on where it stopped.
# PYTHON: the interpreter to use (python3). With --json FILE only FILE is written.
set -euo pipefail
build=$(cd "${1:?usage: peers.sh BUILD [--quick] [options]}" && pwd)
shift
here=$(cd "$(dirname "$0")" && pwd)
environment=${XDG_CACHE_HOME:+$XDG_CACHE_HOME/roughcontact-peers}
environment=${environment:-$build/peers}
export PYTHONDONTWRITEBYTECODE=1
python=$environment/bin/python3
refused=$environment/not-installed.tsv

# A package that cannot be installed leaves its reason; the others run without it.
if ! cmp -s "$here/requirements.txt" "$environment/requirements.txt"; then
  "${PYTHON:-python3}" -m venv "$environment"
  : >"$refused"
  while read -r requirement; do
    [ -n "$requirement" ] || continue
    echo "installing $requirement"
    if ! "$python" -m pip install --quiet --disable-pip-version-check "$requirement" 2>"$environment/pip.log"; then
      printf '%s\t%s\n' "${requirement%%==*}" "$(grep -i error "$environment/pip.log" | tail -n 1 || true)" >>"$refused"
    fi
  done <"$here/requirements.txt"
  "$python" -c 'import numpy' || exit 1
  cp "$here/requirements.txt" "$environment/requirements.txt"
fi
while IFS=$'\t' read -r package reason; do
  echo "$package is not installed: $reason (delete $environment to try again)"
done <"$refused"

"$python" "$here/peers.py" "$build" --not-installed "$refused" "$@"
case " $* " in *" --json"*) exit ;; esac
"$python" "$here/draw.py" "$here/../results" "$here/../../docs/images"
"$python" "$here/report.py" "$here/../results" "$here/../../docs/peers.md"
