#!/bin/sh
# packaging/debian_source.sh OUT: builds the Debian source package of the last commit and the packages from it, in the folder OUT; as root
# in a clean Debian (debootstrap), with a user's rights for the build. lintian looks at them where the clean Debian has it.
set -eu
[ $# = 1 ] || { echo "usage: packaging/debian_source.sh OUT" >&2; exit 2; }
[ "$(id -u)" = 0 ] && command -v debootstrap >/dev/null || { echo "skipped: needs root and debootstrap"; exit 77; }
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
out=$(cd "$1" && pwd)
version=$(sed -n '1s/^roughcontact (\(.*\)-1).*/\1/p' "$here/debian/changelog")
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
debootstrap --variant=buildd bookworm "$root" "${MIRROR:-http://deb.debian.org/debian}" >"$out/debootstrap.log" 2>&1 ||
  { echo "skipped: no Debian can be fetched; see debootstrap.log"; exit 77; }
"$here/recipes.sh" "$out/recipes" # with the address and the maintainer of published.txt
work=$root/build/roughcontact-$version
mkdir -p "$work"
git -C "$here/.." archive --prefix="roughcontact-$version/" HEAD | gzip -n >"$root/build/roughcontact_$version.orig.tar.gz"
tar -xzf "$root/build/roughcontact_$version.orig.tar.gz" -C "$root/build"
cp -R "$out/recipes/debian" "$work/debian"
inside() { chroot "$root" env DEBIAN_FRONTEND=noninteractive LC_ALL=C "$@"; }
inside apt-get install -y -q --no-install-recommends devscripts equivs lintian >"$out/apt.log" 2>&1
inside sh -c "cd /build/roughcontact-$version && mk-build-deps --install --remove --tool 'apt-get -y -q --no-install-recommends' debian/control" \
  >>"$out/apt.log" 2>&1 || { tail "$out/apt.log" >&2; exit 1; }
inside sh -c "useradd -m builder && chown -R builder /build && cd /build/roughcontact-$version && rm -f *.buildinfo *.changes &&
  su builder -c 'DEB_BUILD_OPTIONS=parallel=${JOBS:-2} nice -n 12 dpkg-buildpackage -us -uc'" >"$out/build.log" 2>&1 ||
  { tail -n 30 "$out/build.log" >&2; exit 1; }
inside su builder -c "cd /build && lintian --fail-on error --suppress-tags bogus-mail-host,initial-upload-closes-no-bugs *.changes" || exit 1
find "$root/build" -maxdepth 1 -type f -exec cp {} "$out" \;
ls -l "$out"/*.deb "$out"/*.dsc
