#!/usr/bin/env bash
# components.sh BUILD: every install rule names a component, and every file belongs to exactly one.
set -euo pipefail
build=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }
files() { (cd "$1" && find . -type f -o -type l) | LC_ALL=C sort; }

mapfile -t scripts < <(find "$build" -name cmake_install.cmake -not -path '*/CMakeFiles/*' -not -path "$build/tests/*")
[ ${#scripts[@]} -gt 5 ] || fail "no install rules below $build"
if grep -l '"Unspecified"' "${scripts[@]}"; then fail "these have an install rule without COMPONENT"; fi
components=$(sed -nE 's/.*CMAKE_INSTALL_COMPONENT STREQUAL "([^"]+)" OR NOT CMAKE_INSTALL_COMPONENT.*/\1/p' "${scripts[@]}" | sort -u)

cmake --install "$build" --prefix "$scratch/all" >/dev/null
for component in $components; do
  cmake --install "$build" --prefix "$scratch/$component" --component "$component" >/dev/null
  [ -d "$scratch/$component" ] || fail "component $component installs nothing"
  echo "$component: $(files "$scratch/$component" | wc -l) files"
  files "$scratch/$component" >>"$scratch/parts"
done
repeated=$(LC_ALL=C sort "$scratch/parts" | uniq -d)
[ -z "$repeated" ] || fail "in more than one component: $repeated"
diff <(files "$scratch/all") <(LC_ALL=C sort "$scratch/parts") || fail "the components are not the whole"
for component in runtime surface formats request development fortran octave; do
  grep -qx "$component" <<<"$components" || fail "component $component is gone"
done
! files "$scratch/runtime" | grep -qvE '^./lib[^/]*/(.*/)?(libroughcontact\.so\.|rcb_fft\.so)' ||
  fail "runtime has more than the library and its backend fft"
