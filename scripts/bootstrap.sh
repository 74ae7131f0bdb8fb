#!/usr/bin/env bash
# bootstrap.sh [--tests] [--release]: installs the Debian packages of scripts/packages.txt that are not there yet; with --tests also
# those of packages-tests.txt, without which some tests skip; with --release those of packages-release.txt, for scripts/release.sh.
# A line may have several names: the first one that the system has is installed. What it does not have is named, and the tests that
# want it skip; the build itself needs all of packages.txt.
set -euo pipefail
lists=("$(dirname "$0")/packages.txt")
for option in "$@"; do lists+=("$(dirname "$0")/packages-${option#--}.txt"); done
if ! command -v dpkg-query >/dev/null; then
  echo "not a Debian system: install by hand what corresponds to $(cat "${lists[@]}" | tr "\n" " ")"
  exit 0
fi
missing=()
while read -r line; do
  # shellcheck disable=SC2086
  grep -qx installed < <(dpkg-query -W -f '${db:Status-Status}\n' $line 2>/dev/null) || missing+=("$line")
done < <(cat "${lists[@]}")
[ ${#missing[@]} -gt 0 ] || { echo "all packages are installed"; exit 0; }
as_root=()
[ "$(id -u)" = 0 ] || as_root=(sudo)
"${as_root[@]}" apt-get update -qq
chosen=()
for line in "${missing[@]}"; do
  name=''
  for package in $line; do
    if [[ $(apt-cache policy "$package") == *"Candidate: "[^\(]* ]]; then name=$package; break; fi
  done
  if [ -n "$name" ]; then
    chosen+=("$name")
  elif grep -qxF "$line" "${lists[0]}"; then
    echo "this system has no package ${line// / or }" >&2
    exit 1
  else
    echo "this system has no package ${line// / or }: left out"
  fi
done
[ ${#chosen[@]} -gt 0 ] || exit 0
echo "installing ${chosen[*]}"
# Which libraries serve BLAS and LAPACK: name, path.
blas_of_this_machine() { update-alternatives --get-selections | awk '$1 ~ /^lib(blas|lapack)\.so\.3-/ { print $1, $3 }'; }
before=$(blas_of_this_machine)
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${chosen[@]}" >/dev/null
# OpenBLAS is for tests alone: it starts threads in every program that it serves. Others keep the BLAS that they had.
while read -r name path; do
  kept=$(awk -v name="$name" '$1 == name { print $2 }' <<<"$before") library=${name%%.*}
  [ -n "$kept" ] || kept=/usr/lib/${name#*-}/${library#lib}/$library.so.3
  [ "$path" = "$kept" ] || [ ! -e "$kept" ] || "${as_root[@]}" update-alternatives --quiet --set "$name" "$kept"
done < <(blas_of_this_machine)
