#!/usr/bin/env bash
# sources.sh FOLDER NAME...: fetches the sources of Debian's source packages into FOLDER, without a change to this machine's lists of
# packages. What is there is not fetched again.
set -euo pipefail
mkdir -p "$1/lists/partial"
cd "$1"
shift
missing=()
for name in "$@"; do ls "$name"_*.orig.tar.* >/dev/null 2>&1 || missing+=("$name"); done
[ ${#missing[@]} -gt 0 ] || exit 0
sed 's/^Types: deb$/Types: deb-src/' /etc/apt/sources.list.d/debian.sources >debian.sources
get=(apt-get -q -o "Dir::Etc::sourcelist=$PWD/debian.sources" -o Dir::Etc::sourceparts=/dev/null -o "Dir::State::lists=$PWD/lists"
  -o APT::Sandbox::User=root)
"${get[@]}" update >/dev/null
"${get[@]}" source --tar-only --download-only "${missing[@]}" >/dev/null
