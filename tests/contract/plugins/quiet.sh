#!/usr/bin/env bash
# quiet.sh COMMAND FIXTURE: the command does not mention a plugin that refuses to be used on this machine, unless the user names the
# plugin's component or asks for --explain.
set -euo pipefail
command=$1 fixture=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$fixture" "$folder/"
export RC_PLUGIN_PATH=$folder
words='refuses to be used: no accelerator here'
said() { "$command" "$@" 2>&1 >/dev/null || true; }
"$command" generate spectral --output "$folder/a.gsf" --size 256 --pitch 1um --rms-height 10nm >/dev/null
solve=(solve "$folder/a.gsf" --E 210GPa --nu 0.3 --pressure 100MPa --tol 1e-3)
for each in backends options; do
  [ -z "$(said $each)" ] || { echo "$each says: $(said $each)"; exit 1; }
done
! said "${solve[@]}" | grep "$words" || exit 1
said "${solve[@]}" --explain | grep -q "$words" || { echo "--explain does not have it: $(said "${solve[@]}" --explain)"; exit 1; }
said "${solve[@]}" --backend refuses | grep -q "$words" || { echo "--backend refuses does not have it"; exit 1; }
echo "quiet"
