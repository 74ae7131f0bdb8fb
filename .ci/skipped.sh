#!/usr/bin/env bash
# skipped.sh LOG: fails if ctest's log shows a family of tests (the part of their names before the first dot) of which some were
# skipped and none was run, although the packages of scripts/packages-tests.txt are installed. The family campaign may be: it needs
# pyarrow, which Debian does not have.
set -euo pipefail
families=$(awk '/^ *[0-9]+\/[0-9]+ Test +#[0-9]+: / {
    match($0, /#[0-9]+: [^ ]+/)
    split(substr($0, RSTART, RLENGTH), part, ": ")
    sub(/\..*/, "", part[2])
    if ($0 ~ /\*\*\*Skipped/) skipped[part[2]] = 1; else ran[part[2]] = 1
  }
  END { for (family in skipped) if (!(family in ran) && family != "campaign") print family }' "$1" | sort)
[ -n "$families" ] || exit 0
while read -r line; do
  # shellcheck disable=SC2086
  if ! grep -qx installed < <(dpkg-query -W -f '${db:Status-Status}\n' $line 2>/dev/null); then
    echo "skipped as a whole, perhaps for want of $line: ${families//$'\n'/, }"
    exit 0
  fi
done <"$(dirname "$0")/../scripts/packages-tests.txt"
echo "skipped as a whole, although everything is installed: ${families//$'\n'/, }"
exit 1
