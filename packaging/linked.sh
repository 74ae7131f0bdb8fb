# Sourced: which libraries a wheel carries, and from which Debian package each is. Whoever sources it has fail().
# package_of LIBRARY: the Debian package of a file, as it is named or under its real name.
package_of() {
  local found
  found=$(dpkg -S "$(realpath "$1")" 2>/dev/null || dpkg -S "$1" 2>/dev/null) ||
    fail "$1 is of no Debian package, whose licence the wheel must carry: remove it, or put Debian's first (ldconfig, update-alternatives)"
  echo "${found%%:*}"
}
# original_of COPY LIST: of the libraries in LIST, the one that auditwheel has copied under this name, NAME-HASH.REST for NAME.REST.
original_of() {
  local name
  name=$(basename "$1" | sed -E 's/-[0-9a-f]{8}\././')
  while read -r library; do
    case $name in
      "$(basename "$library")" | "$(basename "$(realpath "$library")")") echo "$library"; return ;;
    esac
  done <"$2"
  fail "no library $name is linked, which $(basename "$1") should be a copy of"
}
# linked FILE...: every library that these files load, sorted.
linked() { { ldd "$@" 2>/dev/null || true; } | awk '$2 == "=>" && $3 ~ "^/" { print $3 }' | sort -u; }
