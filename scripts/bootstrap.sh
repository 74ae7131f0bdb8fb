#!/usr/bin/env bash
# Installs the Debian packages of scripts/packages.txt that are not there yet.
set -euo pipefail
list=$(dirname "$0")/packages.txt
command -v dpkg-query >/dev/null || { echo "not a Debian system: install by hand what corresponds to $(tr "\n" " " <"$list")"; exit 0; }
missing=()
while read -r package; do
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
done <"$list"
[ ${#missing[@]} -gt 0 ] || { echo "all packages are installed"; exit 0; }
echo "installing ${missing[*]}"
as_root=()
[ "$(id -u)" = 0 ] || as_root=(sudo)
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
