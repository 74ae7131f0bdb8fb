#!/usr/bin/env bash
# bootstrap.sh [--tests] [--release]: installs the Debian packages of scripts/packages.txt that are not there yet; with --tests also
# those of packages-tests.txt, without which some tests skip; with --release those of packages-release.txt, for scripts/release.sh.
set -euo pipefail
lists=("$(dirname "$0")/packages.txt")
for option in "$@"; do lists+=("$(dirname "$0")/packages-${option#--}.txt"); done
if ! command -v dpkg-query >/dev/null; then
  echo "not a Debian system: install by hand what corresponds to $(cat "${lists[@]}" | tr "\n" " ")"
  exit 0
fi
missing=()
while read -r package; do
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
done < <(cat "${lists[@]}")
[ ${#missing[@]} -gt 0 ] || { echo "all packages are installed"; exit 0; }
echo "installing ${missing[*]}"
as_root=()
[ "$(id -u)" = 0 ] || as_root=(sudo)
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
