#!/usr/bin/env bash
# linked.sh SOURCE: packaging/linked.sh finds what auditwheel has copied by its soname and by the file that this leads to.
set -euo pipefail
fail() { echo "FAILED: $*"; exit 1; }
. "$1/packaging/linked.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/openblas"
touch "$work/openblas/libopenblasp-r0.3.21.so" "$work/libgsl.so.27.0.0" "$work/openblas/libblas.so.3" "$work/libzip.so.4.0"
ln -s libopenblasp-r0.3.21.so "$work/openblas/libopenblas.so.0"
ln -s openblas/libopenblas.so.0 "$work/libopenblas.so.0"
ln -s openblas/libblas.so.3 "$work/libblas.so.3"
ln -s libgsl.so.27.0.0 "$work/libgsl.so.27"
ln -s libzip.so.4.0 "$work/libzip.so.4"
printf '%s\n' "$work"/lib{openblas.so.0,blas.so.3,gsl.so.27,zip.so.4} >"$work/linked"
expect() {
  local found
  found=$(original_of "/wheel/roughcontact.libs/$1" "$work/linked") || fail "$found"
  [ "$found" = "$work/$2" ] || fail "$1 is a copy of $2, not of $found"
}
expect libopenblasp-r0-234bd196.3.21.so libopenblas.so.0
expect libblas-0123abcd.so.3 libblas.so.3
expect libgsl-8a7bc901.so.27.0.0 libgsl.so.27
expect libzip-deadbeef.so.4 libzip.so.4
! (original_of libother-deadbeef.so.1 "$work/linked") >/dev/null || fail "a copy of nothing is taken"
linked "$(command -v bash)" | grep -q '^/.*libc\.so' || fail "bash links no C library"
if command -v dpkg >/dev/null; then
  [ "$(package_of "$(command -v dpkg)")" = dpkg ] || fail "dpkg is of no package"
  ! (package_of "$work/linked") >/dev/null || fail "a file of no package has one"
fi
