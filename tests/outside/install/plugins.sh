#!/usr/bin/env bash
# plugins.sh SOURCE BUILD CC CXX: builds the example plugins against an installation, as somebody else would, by make and by
# CMake. In the plugin directory they are found without a rebuild, also when the prefix is moved; in the current directory they
# are not.
set -euo pipefail
source=$1 build=$2 cc=$3 cxx=$4
. "$(dirname "$0")/scratch.sh"

boundary=free
command_solve() { clean "$prefix/bin/roughcontact" solve "$scratch/surface.npy" --pitch 1 --unit m --modulus 1 --boundary "$boundary" --approach 0.8 "$@"; }
solve() {  # solve EXPECTED-PAIR OPTION...: prints the load
  local pair=$1 row
  shift
  rm -rf "$scratch/run"
  row=$(command_solve "$@" --out "$scratch/run" --no-maps --quiet 2>&1; answer "$scratch/run")
  [[ $row == *"RC_OK $pair "* ]] || fail "expected a certified answer by $pair: $row"
  awk '{ print $NF }' <<<"$row"
}
answer() {  # answer FOLDER: status, solver/backend and load of the first step
  awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) { sub(/ .*/, "", $i); at[$i] = i } }
    NR == 2 { printf "%s %s/%s %.5g\n", $at["status"], $at["solver"], $at["backend"], $at["load"] }' "$1/steps.csv"
}
listed() { clean "$prefix/bin/roughcontact" "$1" | grep -E "^$2 "; }

strict="-O2 -Wall -Wextra -pedantic -Wshadow -Werror"
build_with() {  # build_with make|cmake KIND: example KIND, installed into the prefix
  local from=$scratch/$1-$2
  cp -r "$source/examples/plugin-$2" "$from"
  if [ "$1" = make ]; then
    clean make -C "$from" CC="$cc" CXX="$cxx" CFLAGS="$strict" CXXFLAGS="$strict -Wno-missing-field-initializers"
    beside_a_plugin_nothing_is_found "$from" "$2"
    clean make -C "$from" install
  else
    clean cmake -S "$from" -B "$from/build" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_C_COMPILER="$cc" -DCMAKE_CXX_COMPILER="$cxx"
    clean cmake --build "$from/build"
    clean cmake --install "$from/build"
  fi
}

beside_a_plugin_nothing_is_found() {  # beside_a_plugin_nothing_is_found FOLDER KIND
  local status=0
  [ -f "$1/rcb_$name.so" ] || fail "make built no rcb_$name.so"
  cd "$1"
  ! listed "${2}s" $name || fail "a plugin in the current directory is used"
  command_solve "--$2" $name 2>"$scratch/message" || status=$?
  cd "$scratch"
  [ $status = 1 ] && grep -q "$2 \"$name\"" "$scratch/message" || fail "$name in the current directory: $(cat "$scratch/message")"
}

prefix=$scratch/prefix
install_to "$prefix"
clean "$prefix/bin/roughcontact" generate spectral --output "$scratch/surface.npy" --size 24 --rms-slope 0.3 >/dev/null
clean "$prefix/bin/roughcontact" generate spectral --output "$scratch/larger.npy" --size 64 --rms-slope 0.3 >/dev/null
for tool in make cmake; do
  plugins=$(pkg --variable=plugindir roughcontact)
  for part in backend:pairs solver:spg kernel:graded; do
    kind=${part%:*} name=${part#*:}
    build_with $tool "$kind" >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "$tool: the $kind"; }
    listed "${kind}s" "$name" | grep -q "rcb_$name.so" || fail "$tool: the $kind is not listed"
    ! readelf -d "$plugins/rcb_$name.so" | grep -q 'NEEDED.*roughcontact' || fail "rcb_$name.so links the library"
    exports=$(nm -D --defined-only "$plugins/rcb_$name.so" | awk '$2 !~ /[WVu]/ { print $3 }')
    [ "$exports" = rc_plugin_query ] || fail "rcb_$name.so exports $exports"
  done
  listed options graded.length >/dev/null || fail "$tool: the kernel's options are not listed"
  expected=$(solve haar-cg/dense --backend dense --solver haar-cg)
  for options in "haar-cg/pairs --backend pairs --solver haar-cg" \
    "haar-cg/pairs --backend pairs --solver haar-cg --threads 2 --set pairs.parallel_from=1" \
    "spg/dense --backend dense --solver spg" "spg/pairs --backend pairs --solver spg --set spg.steps=short"; do
    read -ra words <<<"$options"
    load=$(solve "${words[@]}")
    [ "$load" = "$expected" ] || fail "$tool: ${words[0]} finds load $load, dense $expected"
    echo "$tool: ${words[0]}: load $load"
  done
  hard=$(boundary=periodic; solve haar-cg/dense --backend dense --solver haar-cg)
  soft=$(boundary=periodic; solve haar-cg/dense --backend dense --solver haar-cg --kernel graded --set graded.length=12)
  awk -v soft="$soft" -v hard="$hard" 'BEGIN { exit !(0.1 * hard < soft && soft < hard) }' || fail "$tool: a graded half-space carries $soft, a uniform one $hard"
  # To a rough answer it is the one that takes least time.
  rm -rf "$scratch/run"
  clean "$prefix/bin/roughcontact" solve "$scratch/larger.npy" --pitch 1 --unit m --modulus 1 --boundary free --approach 12 --tol 0.1 --out "$scratch/run" --no-maps --explain >/dev/null 2>"$scratch/why"
  row=$(answer "$scratch/run")
  [[ $row == "RC_OK spg/"* ]] || fail "auto does not take spg: $row $(cat "$scratch/why")"
  grep -q "spg on .* taken" "$scratch/why" && grep -q "haar-cg on .* slower" "$scratch/why" || fail "no reasons: $(cat "$scratch/why")"
  mv "$prefix" "$scratch/moved-$tool"
  prefix=$scratch/moved-$tool
  find_pc "$prefix"
  solve spg/pairs --backend pairs --solver spg >/dev/null
  rm "$(pkg --variable=plugindir roughcontact)"/rcb_{pairs,spg,graded}.so
  ! listed backends pairs || fail "a plugin that is gone is listed"
done
echo "plugins are found where they belong"
