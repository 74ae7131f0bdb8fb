#!/bin/sh
# packaging/recipes.sh OUT [FACTS]: the recipes of package managers, as their repositories want them, in the folder OUT, with the
# address, the checksums and the maintainer of FACTS (packaging/published.txt): conan, vcpkg, spack, conda (for conda-forge) and debian.
set -eu
[ $# = 1 ] || [ $# = 2 ] || { echo "usage: packaging/recipes.sh OUT [FACTS]" >&2; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
facts=${2:-$here/published.txt}
mkdir -p "$1"
out=$(cd "$1" && pwd)
value() { sed -n "s|^$1=||p" "$facts"; }
version=$(sed -n 's/^project(roughcontact VERSION \([0-9.]*\).*/\1/p' "$here/../CMakeLists.txt")
for kind in conan vcpkg spack conda debian; do
  rm -rf "${out:?}/$kind"
  cp -R "$here/$kind" "$out/$kind"
  find "$out/$kind" -type f -exec sed -i "s|@VERSION@|$version|g; s|@HOMEPAGE@|$(value homepage)|g; s|@ARCHIVE@|$(value archive)|g
    s|@SHA256@|$(value sha256)|g; s|@SHA512@|$(value sha512)|g; s|@MAINTAINER@|$(value maintainer)|g; s|@ACCOUNT@|$(value account)|g" {} +
done
# The two that also build this tree as it is say so in their own files.
sed -i "s|^  path: ../..|  url: $(value archive)|; s|^  use_gitignore: true|  sha256: $(value sha256)|" "$out/conda/recipe.yaml"
printf '  homepage: %s\n\nextra:\n  recipe-maintainers:\n    - %s\n' "$(value homepage)" "$(value account)" >>"$out/conda/recipe.yaml"
head="    homepage = \"$(value homepage)\"\\n    url = \"$(value archive)\"\\n\\n    maintainers(\"$(value account)\")\\n\\n"
sed -i "s|^    version(\"\(.*\)\")|$head    version(\"\1\", sha256=\"$(value sha256)\")|" "$out/spack/package.py"
