#!/usr/bin/env bash
# packaging/build.sh [DIRECTORY]: makes the Debian packages of this source tree, in DIRECTORY (build-packages/packages if none
# is named), with Debian's compiler flags, and has lintian look at them. DEBFULLNAME and DEBEMAIL name the maintainer.
set -euo pipefail
mkdir -p "${1:-$(dirname "$0")/../build-packages/packages}"
out=$(cd "${1:-$(dirname "$0")/../build-packages/packages}" && pwd)
cd "$(dirname "$0")/.."
build=build-packages
export DEBFULLNAME=${DEBFULLNAME:-roughcontact developers} DEBEMAIL=${DEBEMAIL:-roughcontact@packages.invalid}
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || date +%s)}
export SOURCE_DATE_EPOCH
export DEB_BUILD_MAINT_OPTIONS=hardening=+bindnow DEB_CFLAGS_MAINT_STRIP="-g -O2" DEB_CXXFLAGS_MAINT_STRIP="-g -O2"
flags() { for name in "$@"; do dpkg-buildflags --get "$name"; done | tr '\n' ' '; }

cmake -S . -B $build -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr \
  -DCMAKE_INSTALL_LIBDIR="lib/$(dpkg-architecture -q DEB_HOST_MULTIARCH)" -DCMAKE_SKIP_INSTALL_RPATH=ON -DCMAKE_BUILD_RPATH_USE_ORIGIN=ON \
  -DCMAKE_INSTALL_SO_NO_EXE=1 \
  -DCMAKE_C_FLAGS="$(flags CFLAGS CPPFLAGS)" -DCMAKE_CXX_FLAGS="$(flags CXXFLAGS CPPFLAGS)" -DCMAKE_EXE_LINKER_FLAGS="$(flags LDFLAGS)" \
  -DCMAKE_SHARED_LINKER_FLAGS="$(flags LDFLAGS)" -DCMAKE_MODULE_LINKER_FLAGS="$(flags LDFLAGS)" \
  -DRC_CUDA=OFF -DRC_BUILD_TESTS=OFF -DRC_BUILD_BENCH=OFF -DRC_BUILD_EXAMPLES=OFF >/dev/null
cmake --build $build -j "$(nproc)"
rm -rf $build/_CPack_Packages "$out"/*roughcontact*.deb
(cd $build && cpack -G DEB -B "$out" >cpack.log 2>&1) || { tail -30 $build/cpack.log; exit 1; }
rm -rf "$out/_CPack_Packages"

# CPack puts calls of ldconfig beside the trigger by which Debian wants it, and the hour of the build into the archives.
for deb in "$out"/*.deb; do
  tree=$(mktemp -d)
  dpkg-deb --raw-extract "$deb" "$tree"
  [[ $deb != */libroughcontact*[0-9]_* ]] || rm -f "$tree"/DEBIAN/{postinst,postrm}
  dpkg-deb --build --root-owner-group -Zxz "$tree" "$deb" >/dev/null
  rm -rf "$tree"
done
ls -l "$out"/*.deb
if command -v lintian >/dev/null; then
  lintian --allow-root --fail-on error --suppress-tags bogus-mail-host,initial-upload-closes-no-bugs "$out"/*.deb
fi
