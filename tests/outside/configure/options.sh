#!/usr/bin/env bash
# options.sh SOURCE: every wrong value of an option of CMake's gets one line, which names the option, the value and what is right.
set -euo pipefail
source=$1
fail() { echo "FAILED: $*" >&2; exit 1; }

# refused OPTION=VALUE TEXT
refused() {
  local said
  said=$(cmake "-D$1" -P "$source/cmake/RoughcontactOptions.cmake" 2>&1) && fail "$1 is accepted"
  said=$(tr -s ' \n' ' ' <<<"$said")
  [[ $said == *"$2"* ]] || fail "$1 gives: $said"
  echo "$1: ok"
}
accepted() {
  cmake "-D$1" -P "$source/cmake/RoughcontactOptions.cmake" || fail "$1 is refused"
}

refused 'RC_BUILTIN_BACKENDS=dense;dnse' 'RC_BUILTIN_BACKENDS: there is no backend "dnse"; there are callback, cholmod, dense, fft, split'
refused RC_MODULE_BACKENDS=cuda 'RC_MODULE_BACKENDS: the plugin cuda is built by RC_CUDA=ON'
refused RC_CUDA=perhaps 'RC_CUDA = "perhaps" is none of ON, OFF, AUTO'
refused RC_BUILD_MPI=perhaps 'RC_BUILD_MPI = "perhaps" is none of ON, OFF, AUTO'
refused 'RC_MODULE_BACKENDS=fft,split' 'RC_MODULE_BACKENDS: there is no backend "fft,split"'
refused RC_SANITIZE=adress 'RC_SANITIZE: there is no sanitizer "adress"; there are address, leak'
refused RC_SANITIZE=address,thread 'thread goes with undefined alone'
refused RC_TEST_FAMILIES=no-such 'RC_TEST_FAMILIES: there is no family "no-such"'
for option in RC_BUILD_SURFACE RC_BUILD_FORMATS RC_BUILD_TOOLS RC_BUILD_TESTS RC_BUILD_EXAMPLES RC_BUILD_BENCH RC_BUILD_FUZZERS RC_STATIC_COMMAND RC_INSTALL RC_WERROR; do
  refused $option=perhaps "$option = \"perhaps\" is neither ON nor OFF"
  accepted $option=OFF
done
# Options that nobody has checked would be checked by nobody.
while read -r option; do
  grep -q "$option" "$source/cmake/RoughcontactOptions.cmake" || fail "$option is not checked"
done < <(sed -nE 's/^(option|set)\((RC_[A-Z_]+) .*(\$\{PROJECT_IS_TOP_LEVEL\}|OFF|CACHE STRING.*)\)?$/\2/p' "$source/CMakeLists.txt")
accepted 'RC_BUILTIN_BACKENDS=callback;dense;dense'
accepted RC_SANITIZE=thread,undefined
accepted 'RC_TEST_FAMILIES=behaviour/threads;behaviour/batch'
