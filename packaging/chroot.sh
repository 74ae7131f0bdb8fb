#!/usr/bin/env bash
# packaging/chroot.sh PACKAGES: installs the Debian packages of the folder PACKAGES, made by packaging/build.sh, into a clean
# system of this release of Debian, and uses them there: every backend from the command, a C program through pkg-config, and
# after removal nothing is left. Needs root, debootstrap and a mirror of Debian; exit code 77 without. Some minutes.
set -euo pipefail
[ $# = 1 ] || { echo "usage: $0 PACKAGES"; exit 1; }
packages=$(cd "$1" && pwd)
. "$(dirname "$0")/clean_system.sh"
ls "$packages"/*.deb >/dev/null || fail "no packages in $packages; packaging/build.sh makes them"
files() { for name in "$@"; do (cd "$root" && ls packages/$name"_"*.deb); done | sed 's#^#/#'; }  # as seen from inside
add() { quietly inside apt-get install -y -qq --no-install-recommends "$@"; }

clean_system ca-certificates
mount -t proc proc "$root/proc"
cp /etc/resolv.conf "$root/etc/resolv.conf"
mkdir "$root/packages"
cp "$packages"/*.deb "$root/packages"
quietly inside apt-get update -qq

add $(files libroughcontact0 libroughcontact-surface0 libroughcontact-formats0 libroughcontact-request0 libroughcontact-flow0 libroughcontact-mpi0 roughcontact-tools)
inside roughcontact --version
inside roughcontact generate spectral --output /tmp/surface.npy --size 64 --rms-slope 0.1 >/dev/null
solve() {  # the table of steps, which names the backend
  inside rm -rf /tmp/run
  inside roughcontact solve /tmp/surface.npy --pitch 1 --unit m --modulus 1 --pressure 0.005 --out /tmp/run --no-maps --quiet "$@" 2>&1 && inside cat /tmp/run/steps.csv
}
[[ $(solve --backend fft) == *RC_OK*",fft,"* ]] || fail "the command without more plugins: $(solve --backend fft)"
[[ $(solve --backend split || true) == *"not installed"* ]] || fail "split without its package: $(solve --backend split || true)"

add $(files libroughcontact-backend-split libroughcontact-backend-cholmod)
inside roughcontact backends
for backend in dense fft cholmod; do
  [[ $(solve --backend $backend) == *RC_OK*",$backend,"* ]] || fail "the command on $backend: $(solve --backend $backend)"
done
add $(files roughcontact-mpi) openmpi-bin
[[ $(inside env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe -n 2 roughcontact-mpi /tmp/surface.npy \
  --pitch 1 --unit m --modulus 1 --pressure 0.005 --boundary periodic --out /tmp/run-mpi 2>&1) == *RC_OK* ]] || fail "roughcontact-mpi on two ranks"
# The licences of the packages rest on this: the solver library links neither FFTW, SuiteSparse nor GSL.
library=$(inside dpkg -L libroughcontact0 | grep 'libroughcontact.so.[0-9]*$')
! inside ldd "$library" | grep -E 'fftw|cholmod|gsl' || fail "GPL in the library"

add $(files '*') gcc libc6-dev pkg-config
cp "$source/examples/press_sphere.c" "$source/examples/press_rough.c" "$root/tmp"
quietly inside sh -c 'cc /tmp/press_sphere.c -o /tmp/press_sphere $(pkg-config --cflags --libs roughcontact)'
quietly inside sh -c 'cc /tmp/press_rough.c -o /tmp/press_rough $(pkg-config --cflags --libs roughcontact roughcontact-surface)'
for backend in dense fft cholmod; do
  inside /tmp/press_sphere $backend
done
inside /tmp/press_rough | tail -1
if ls "$root"/packages/python3-roughcontact_*.deb >/dev/null 2>&1; then
  inside python3 - <<'END'
import numpy, roughcontact as rc
x = numpy.arange(32) - 15.5
result = rc.solve(-(x[:, None] ** 2 + x ** 2) / 100, pitch=1.0, modulus=1.0, boundary="free", approach=1.0)
print("python: load", round(result.load, 4), "on", result.backend)
END
fi

inside dpkg -l '*roughcontact*' | awk '$1 == "ii" { print $2, $3 }'
quietly inside sh -c 'apt-get purge -y -qq $(dpkg-query -W -f "\${Package} " "*roughcontact*") && apt-get autoremove --purge -y -qq'
left=$(inside find / -xdev -name '*roughcontact*' -not -path '/proc/*' -not -path '/packages/*' -not -path '/tmp/*')
[ -z "$left" ] || fail "left behind: $left"
echo "the packages install, work and go without a trace"
