#!/usr/bin/env bash
# site.sh BUILD: the documents as a web site, BUILD/site/html/index.html, which can be read and searched without a network. The library of
# BUILD tells what the Python package has. A warning, a link or an anchor that leads nowhere is an error; exit code 77 where what is needed
# cannot be had.
set -euo pipefail
[ $# = 1 ] || { echo "usage: $0 BUILD"; exit 1; }
command -v doxygen >/dev/null || { echo "skipped: doxygen is not installed"; exit 77; }
build=$(cd "$1" && pwd)
root=$(cd "$(dirname "$0")/.." && pwd)
python=$("$root/scripts/docs-venv.sh" "$build")
site=$build/site
rm -rf "$site"
mkdir -p "$site/source/bindings/python"
cp -r "$root"/*.md "$root"/CITATION.cff "$root"/{backends,docs,examples,fuzz,include,integrations,packaging,src} "$site/source"
cp -r "$root"/bindings/python/gpl "$site/source/bindings/python"
"$root/scripts/reference.sh" "$site/doxygen" >/dev/null
export PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$root/bindings/python ROUGHCONTACT_LIBRARY=$build/lib/libroughcontact.so
export RC_DOXYGEN_XML=$site/doxygen/xml
"$python" "$root/docs/site/reference.py" "$root" "$site/source/reference"
"$python" -m sphinx -q -W --keep-going -b html -c "$root/docs/site" -d "$site/doctrees" "$site/source" "$site/html"
echo '<meta http-equiv="refresh" content="0; url=docs/index.html">' >"$site/html/index.html"
echo "$(find "$site/html" -name '*.html' | wc -l) pages in $site/html"
