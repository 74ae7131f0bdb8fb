#!/usr/bin/env bash
# release.sh [FOLDER]: makes a release of this commit in FOLDER (build-release if none is named): source archive, source distribution
# and wheel of the Python package, Debian packages, site, paper, notes, bill of materials (CycloneDX) and checksums. Two runs give the
# same bytes. Nothing may differ from the commit. What is needed: scripts/bootstrap.sh --tests --release.
# release.sh --check: a line for each thing that a release needs, ready or not; exit status 1 if one is not.
set -euo pipefail
cd "$(dirname "$0")/.."
version=$(sed -nE 's/^project\(roughcontact VERSION ([0-9.]+).*/\1/p' CMakeLists.txt)
name=roughcontact-$version

clean() { [ -z "$(git status --porcelain)" ] || { git status --short; return 1; }; }
tagged() { git tag --points-at HEAD | grep -x "v$version" || { echo "git tag -a v$version"; return 1; }; }
dates() {
  local noted cited
  noted=$(sed -nE "s/^## $version \((.*)\)/\1/p" CHANGELOG.md)
  cited=$(sed -n 's/^date-released: //p' CITATION.cff)
  echo "CHANGELOG.md ${noted:-none}, CITATION.cff ${cited:-none}"
  [[ $noted =~ ^[0-9]{4}-[0-9]{2}-[0-9]{2}$ && $noted = "$cited" ]]
}
tested() {
  grep -s "^$(git rev-parse 'HEAD^{tree}') .* 0 failed" build-gcc/full-test | cut -d ' ' -f 2- | grep . ||
    { echo "./test.sh --full has not passed in this folder on this commit"; return 1; }
}
words() { local n; n=$(sed '1,/^# Summary$/d' paper/paper.md | wc -w); [ "$n" -ge 750 ] && [ "$n" -le 1750 ] || { echo "$n words"; return 1; }; }
tools() {
  local tool missing=''
  for tool in doxygen dpkg-buildflags dpkg-deb pandoc pdflatex; do command -v $tool >/dev/null || missing+=" $tool"; done
  [ -z "$missing" ] || { echo "missing:$missing (scripts/bootstrap.sh --tests --release)"; return 1; }
}

if [ "${1:-}" = --check ]; then
  result=0
  check() {
    local said
    if said=$("${@:2}" 2>&1); then
      echo "ready      $1${said:+: ${said##*$'\n'}}"
    else
      result=1
      echo "NOT READY  $1: ${said//$'\n'/$'\n'           }"
    fi
  }
  check "nothing differs from the commit" clean
  check "tag" tagged
  check "versions" python3 -B tests/outside/packages/versions.py . "$version"
  check "dates" dates
  check "links" python3 -B tests/outside/docs/links.py
  check "words of the paper" words
  check "full test" tested
  check "measured numbers" python3 -B bench/outdated.py
  check "programs" tools
  exit $result
fi

clean && tools
mkdir -p "${1:-build-release}"
out=$(cd "${1:-build-release}" && pwd)
rm -rf "${out:?}"/*
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH FORCE_SOURCE_DATE=1 TZ=UTC LC_ALL=C.UTF-8
umask 022
step() { echo "== $* ($((SECONDS / 60)) min)"; }

step "source"
git -c tar.umask=0022 archive --prefix="$name/" HEAD | gzip -9n >"$out/$name-source.tar.gz"
# All the rest is made from the archive.
tar -xzf "$out/$name-source.tar.gz" -C "$work"
cd "$work/$name"
sed -n "/^## $version /,/^## /{/^## [^$version]/d;p}" CHANGELOG.md >"$out/$name-notes.md"

step "paper"
(cd paper && pandoc paper.md --citeproc --pdf-engine=pdflatex -M author="The roughcontact developers" -V geometry:margin=25mm \
  -V colorlinks -V header-includes='\pdftrailerid{}' -o "$out/$name-paper.pdf")

step "Debian packages"
packaging/build.sh "$out" >"$work/log" 2>&1 || { tail -30 "$work/log"; exit 1; }

step "site"
scripts/site.sh build-packages >"$work/log" 2>&1 || { tail -30 "$work/log"; exit 1; }
tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$SOURCE_DATE_EPOCH" -c -C build-packages/site --transform "s/^html/$name-site/" html |
  gzip -9n >"$out/$name-site.tar.gz"

step "Python package"
packaging/wheel.sh "$out"

step "bill of materials, checksums"
python3 -B scripts/bill_of_materials.py "$version" "$out" >"$work/bill"
mv "$work/bill" "$out/$name.cdx.json"
(cd "$out" && sha256sum -- * >"$work/sums" && mv "$work/sums" SHA256SUMS)
ls -l "$out"
