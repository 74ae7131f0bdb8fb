# Sourced by scripts that try a package where nothing else is: a clean system of this release of Debian, from the mirror of this
# machine. Needs root, debootstrap and a mirror; exit code 77 without.
#   clean_system PACKAGE,...   makes it in $root, with these packages; it goes when the script ends
#   inside COMMAND...          runs there
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
skip() { echo "skipped: $*"; exit 77; }
fail() { echo "FAILED: $*" >&2; exit 1; }
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 "$@"; }
quietly() { "$@" >"$root.log" 2>&1 || { tail -40 "$root.log"; fail "$*"; }; rm -f "$root.log"; }

clean_system() {
  [ "$(id -u)" = 0 ] || skip "needs root"
  command -v debootstrap >/dev/null || skip "debootstrap is not installed"
  local release mirror
  release=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
  mirror=$(apt-get indextargets --format '$(REPO_URI)' "Codename: $release" 'Label: Debian' 'Created-By: Packages' | head -1)
  [ -n "$release" ] && [ -n "$mirror" ] || skip "apt knows no mirror of Debian"
  root=$(mktemp -d)
  trap 'umount -q "$root/proc" || true; rm -rf --one-file-system "$root" "$root.log"' EXIT
  echo "a clean $release from the mirror of this machine"
  quietly debootstrap --variant=minbase --include="$1" "$release" "$root" "$mirror"
}
