#!/usr/bin/env bash
# release.sh SOURCE [whole]: scripts/release.sh --check finds in a clone what a release lacks, and what it has. whole: releases made in
# two folders have the same bytes. Exit code 77 without a history of git, or the programs.
set -euo pipefail
skip() { echo "skipped: $*"; exit 77; }
git -C "$1" rev-parse HEAD >/dev/null 2>&1 || skip "no history of git"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
git clone -q --shared "$1" "$work/one"
cd "$work/one"
if [ "${2:-}" = whole ]; then
  if scripts/release.sh --check | grep "NOT READY  programs"; then exit 77; fi
  git clone -q --shared "$1" "$work/another folder"
  scripts/release.sh "$work/first"
  "$work/another folder/scripts/release.sh" "$work/second"
  (cd "$work/first" && sha256sum --check --quiet SHA256SUMS)
  diff -r "$work/first" "$work/second"
  exit
fi

version=$(sed -nE 's/^project\(roughcontact VERSION ([0-9.]+).*/\1/p' CMakeLists.txt)
git config user.name test
git config user.email test@example.invalid
expect() {  # LINE...: of what --check prints, or their beginnings
  local said line
  said=$(scripts/release.sh --check || true)
  for line in "$@"; do [[ $'\n'$said == *$'\n'"$line"* ]] || { printf '%s\n' "FAILED: no line '$line' in" "$said"; exit 1; }; done
}
expect "ready      nothing differs from the commit" "NOT READY  tag" "ready      links" "NOT READY  full test"
git tag -m release "v$version"
mkdir build-gcc
echo "$(git rev-parse 'HEAD^{tree}') 2026-01-01: 1 passed, 0 failed, 0 skipped" >build-gcc/full-test
expect "ready      tag: v$version" "ready      full test: 2026-01-01: 1 passed"
sed -i "s/^version: .*/version: 9.9.9/; s/^date-released: .*/date-released: 2000-01-01/" CITATION.cff
expect "NOT READY  nothing differs" "NOT READY  versions: CITATION.cff" "NOT READY  dates" "ready      tag"
git commit -qam "another version"
expect "NOT READY  tag" "NOT READY  full test"
! scripts/release.sh --check >/dev/null
