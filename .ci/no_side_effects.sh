#!/usr/bin/env bash
# no_side_effects.sh BUILD: the library and its plugins import nothing that prints, ends the process, or changes its state.
set -euo pipefail
build=$1
forbidden='^(_?_?exit|_Exit|quick_exit|abort|__assert_fail|raise|kill|signal|sigaction|v?f?printf|v?dprintf|__v?f?printf_chk|puts|fputs|putchar|fputc|stdout|stderr|stdin|perror|psignal|setlocale|setenv|putenv|unsetenv|chdir|umask|atexit|system|popen|fork|execve?|fesetround|feenableexcept|srand|rand|_ZSt4(cout|cerr|clog)|fftwf?_(cleanup|cleanup_threads|forget_wisdom|import_wisdom_from_file.*|import_wisdom|import_system_wisdom))$'
found=0
for file in "$build"/lib/libroughcontact.so "$build"/lib/libroughcontact-{surface,formats,flow}.so "$build"/lib/roughcontact/abi-*/*.so; do
  [ -e "$file" ] || continue
  imports=$(nm -D -u "$file" | awk '{ sub(/@.*/, "", $2); print $2 }')
  if bad=$(grep -E "$forbidden" <<<"$imports"); then
    echo "$file imports: ${bad//$'\n'/ }"
    found=1
  else
    echo "$file: $(wc -l <<<"$imports") imports, none forbidden"
  fi
done
exit $found
