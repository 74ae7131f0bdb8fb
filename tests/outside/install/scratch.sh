# Sourced by the tests of this folder: a scratch folder, an installation in it, and commands that see nothing but PATH.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }
clean() { env -i PATH="$PATH" PKG_CONFIG_PATH="$pc" "$@"; }
pkg() { clean pkg-config "$@"; }
find_pc() { pc=$(dirname "$(find "$1" -name roughcontact.pc)"); }  # find_pc PREFIX: where the pkg-config files are
install_to() {  # install_to PREFIX: from $build
  cmake --install "$build" --prefix "$1" >/dev/null
  find_pc "$1"
}
