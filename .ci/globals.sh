#!/usr/bin/env bash
# globals.sh BUILD: no mutable global or static data in our objects but what .ci/globals.allow lists (one regular expression a
# line, matched against the demangled name).
set -euo pipefail
build=$1
allow=$(dirname "$0")/globals.allow
objects=$(find "$build/src" "$build/backends" "$build/surface" "$build/formats" "$build/flow" -name '*.o' 2>/dev/null | sort -u || true)  # a folder may not be there
[ -n "$objects" ] || { echo "no objects under $build"; exit 1; }
# shellcheck disable=SC2086
mutable=$(nm -C -f sysv $objects | awk -F ' *[|] *' '$4 ~ /OBJECT|TLS/ && $7 ~ /^\.t?(data|bss)/ && $7 !~ /^\.data\.rel\.ro/ { print $1 }' |
  sort -u | grep -vEf <(grep -v '^#' "$allow") || true)
if [ -n "$mutable" ]; then
  echo "mutable data that .ci/globals.allow does not list:"
  echo "$mutable"
  exit 1
fi
echo "$(wc -w <<<"$objects") objects: no mutable data beyond the list"
