#!/usr/bin/env bash
# packaging/debian_source.sh OUT: makes the Debian source package of the last commit, with debian/ from packaging/debian, and by
# dpkg-buildpackage its packages, in a clean system of this release of Debian; lintian looks at them. All go into the folder OUT.
# JOBS: compilers at a time. Needs root, debootstrap and a mirror of Debian; exit code 77 without.
set -euo pipefail
[ $# = 1 ] || { echo "usage: $0 OUT"; exit 1; }
mkdir -p "$1"
out=$(cd "$1" && pwd)
. "$(dirname "$0")/clean_system.sh"
version=$(sed -n '1s/^roughcontact (\(.*\)-1).*/\1/p' "$source/packaging/debian/changelog")
clean_system ca-certificates
mount -t proc proc "$root/proc"
cp /etc/resolv.conf "$root/etc/resolv.conf"
chmod 755 "$root" # the user who builds has to reach it
quietly inside apt-get update -qq
quietly inside apt-get install -y -qq --no-install-recommends build-essential devscripts equivs lintian

tree=$root/build/roughcontact-$version
mkdir -p "$root/build"
git -C "$source" archive --prefix="roughcontact-$version/" HEAD | gzip -n >"$root/build/roughcontact_$version.orig.tar.gz"
tar -xzf "$root/build/roughcontact_$version.orig.tar.gz" -C "$root/build"
"$source/packaging/recipes.sh" "$root/recipes"
cp -R "$root/recipes/debian" "$tree/debian"
in_tree() { inside sh -c "cd /build/roughcontact-$version && $1"; }
quietly in_tree "mk-build-deps --install --remove --tool 'apt-get -y -q --no-install-recommends' debian/control && rm -f *.buildinfo *.changes"
inside useradd -m builder
inside chown -R builder /build
quietly in_tree "su builder -c 'DEB_BUILD_OPTIONS=parallel=${JOBS:-$(nproc)} dpkg-buildpackage -us -uc'"
find "$root/build" -maxdepth 1 -type f -exec cp {} "$out" \;
ls -l "$out"/*.dsc "$out"/*.deb
inside su builder -c "cd /build && lintian --fail-on error --suppress-tags bogus-mail-host,initial-upload-closes-no-bugs *.changes"
