#!/usr/bin/env bash
# microsoft.sh FOLDER EMULATOR...: a program in C and one in C++ by Microsoft's rules for layouts and calls, made by clang with the headers
# in FOLDER, linked by LLVM's linker with the import library roughcontact.lib there, and run. They use no C library.
set -euo pipefail
folder=$1
shift
for tool in clang lld-link; do command -v $tool >/dev/null || { echo "Microsoft's rules: not tried, $tool is not installed"; exit 0; }; done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cat >"$scratch/press.c" <<'END'
#include <roughcontact/direct.h>
#include <roughcontact/formats.h>
#include <roughcontact/plugin.h>
#include <roughcontact/surface.h>

#ifdef __cplusplus
extern "C" {
#endif
int _fltused = 0; /* Microsoft's compilers refer to it where there are doubles */

void *memset(void *to, int value, size_t bytes) { /* what compilers call to clear a struct */
  volatile char *each = (volatile char *)to;
  while (bytes-- > 0) *each++ = (char)value;
  return to;
}
int start(void) {
  static double gap[64], p[64];
  rc_system system = RC_SYSTEM_INIT;
  rc_step step = RC_STEP_INIT;
  rc_result result = RC_RESULT_INIT;
  int i;
  for (i = 0; i < 64; ++i) gap[i] = (i % 8 - 3.5) * (i % 8 - 3.5) + (i / 8 - 3.5) * (i / 8 - 3.5);
  system.boundary = RC_BOUNDARY_FREE;
  system.nx = system.ny = 8;
  system.hx = system.hy = system.modulus = 1;
  step.control = RC_CONTROL_LOAD;
  step.target = 5;
  step.undeformed_gap.data = gap;
  result.p.data = p;
  if (rc_solve(&system, &step, 0, &result) != RC_OK) return 1;
  return result.contacts > 3 && result.load > 4.999999 && result.load < 5.000001 && p[27] > p[0] ? 42 : 2;
}
#ifdef __cplusplus
}
#endif
END
for form in "c c99" "c++ c++20"; do
  read -r language standard <<<"$form"
  clang --target=x86_64-pc-windows-msvc -x "$language" -std="$standard" -O1 -ffreestanding -Wall -Werror -I"$folder/include" \
    -c "$scratch/press.c" -o "$scratch/press.obj"
  lld-link /nologo /nodefaultlib /subsystem:console /entry:start "/out:$folder/bin/microsoft.exe" "$scratch/press.obj" "$folder/lib/roughcontact.lib"
  code=0
  "$@" "$folder/bin/microsoft.exe" || code=$?
  [ $code = 42 ] || { echo "FAILED: $form by Microsoft's rules ended with $code" >&2; exit 1; }
  echo "Microsoft's rules, $standard: certified"
done
