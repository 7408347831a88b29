#!/usr/bin/env bash
# check_packages.sh BUILD: makes the Debian packages of a build tree and installs them, as apt does, into
# a clean Debian 12 that mmdebstrap makes; there a mission is flown in virtual time and over DDS by the
# account of the daemons, and systemd judges the units. Needs root, mmdebstrap and a Debian mirror.
# shellcheck disable=SC2016  # what stands in single quotes is for other shells
set -euo pipefail
build=$(cd "$1" && pwd)
source "$(dirname "${BASH_SOURCE[0]}")/clean_root.sh"
root=$work/root
said() { echo "packages: $*"; }

for program in file dpkg-shlibdeps; do # that cpack runs: it came with scripts/bootstrap
  package=$(dpkg-query -S "*/bin/$program" | cut -d: -f1)
  grep -qx "$package" "$(dirname "${BASH_SOURCE[0]}")/../../scripts/packages.txt" || { echo "FAILED: $package is not in scripts/packages.txt" >&2; exit 1; }
done
# shellcheck disable=SC2119  # all components
make_packages
cd "$work/packages"
said "$(du -k -- *.deb | awk '{printf "%s%s %d kB", n++ ? ", " : "", $2, $1}')"

make_root "$root"
inside() { # COMMAND…: in the clean root, as the daemons' account, with a network of its own
  unshare -nmp --fork bash -c 'root=$1; shift
    mount -t proc proc "$root/proc"; mount -t tmpfs tmpfs "$root/dev/shm"; ip link set lo up
    exec chroot --userspec=skein:skein "$root" "$@"' inside "$root" "$@" >"$log" 2>&1
}
said "installed with $(chroot "$root" dpkg-query -W -f '${Installed-Size} kB' skein), the root has $(du -sm "$root" | cut -f1) MB"

for guide in man/man1/skein-run.1 man/man8/skein-ground.8 bash-completion/completions/skein \
             zsh/vendor-completions/_skein fish/vendor_completions.d/skein.fish; do
  [ -s "$root/usr/share/$guide" ] || fail "no /usr/share/$guide"
done
inside bash -c 'source /usr/share/bash-completion/completions/skein; COMP_WORDS=(skein run --virt) COMP_CWORD=2; _skein; echo "$COMPREPLY"'
grep -qx -- --virtual "$log" || fail "completion"
said "manual pages and completion are there"
inside skein storm --laws || fail "skein-lab is not beside skein"
inside skein mastn generate || fail "skein-tools is not beside skein"
[ -x "$root/usr/bin/skein-live" ] || fail "skein-live is not beside skein"
inside skein run /usr/share/skein/scenarios/comets/confirmed.yaml --virtual --out /tmp/virtual || fail "a mission in virtual time"
said "$(tail -n 1 "$log")"
inside skein run /usr/share/skein/scenarios/comets/confirmed.yaml --rate 60 --out /tmp/dds || fail "a mission over DDS"
said "$(tail -n 1 "$log")"
inside skein-make-keys /tmp/keys /usr/share/skein/scenarios/comets/confirmed.yaml || fail "keys"
said "$(tail -n 1 "$log")"
for daemon in ground sim; do
  inside "skein-$daemon" --config "/etc/skein/$daemon.yaml" --show-config || fail "/etc/skein/$daemon.yaml"
  grep -q "^state: \. *# /etc/skein/$daemon.yaml" "$log" || fail "skein-$daemon keeps nothing for its next life"
done
for daemon in ddn mavlink; do
  inside "skein-$daemon" --config "/etc/skein/$daemon.yaml" --uav marvin --show-config || fail "/etc/skein/$daemon.yaml"
done

if command -v systemd-analyze >/dev/null; then
  cp -r "$root/usr/lib/systemd/system" "$work/units"
  cp "$work/units/skein-ddn@.service" "$work/units/skein-ddn@marvin.service"
  cp "$work/units/skein-mavlink@.service" "$work/units/skein-mavlink@marvin.service"
  for unit in skein-ground skein-sim skein-ddn@marvin skein-mavlink@marvin; do
    # Its commands stand in the clean root, not here.
    sed -i "s|^ExecStart=skein-|ExecStart=$root/usr/bin/skein-|" "$work/units/$unit.service"
    SYSTEMD_LOG_LEVEL=warning systemd-analyze verify --man=no "$work/units/$unit.service" >"$log" 2>&1 || fail "$unit"
    ! grep -q "$unit" "$log" || fail "$unit"
    systemd-analyze security --offline=true --threshold=25 "$work/units/$unit.service" >"$log" 2>&1 || fail "$unit is too open"
    said "$unit: $(tail -n 1 "$log" | sed 's/^[^O]*//')"
  done
fi
chroot "$root" sh -c 'cd /tmp && apt-get install -s --no-install-recommends ./libskein-dev_*.deb ./skein-refine_*.deb' >"$log" 2>&1 ||
  fail "what libskein-dev or skein-refine depends on is not in Debian"
# As after a mission by the units.
mkdir -p "$root/var/lib/skein/marvin" "$root/etc/systemd/system/multi-user.target.wants"
touch "$root/var/lib/skein/marvin/marvin.state"
ln -s /usr/lib/systemd/system/skein-ddn@.service "$root/etc/systemd/system/multi-user.target.wants/skein-ddn@marvin.service"
chroot "$root" apt-get remove -y skein >"$log" 2>&1 || fail "remove"
[ -f "$root/var/lib/skein/marvin/marvin.state" ] && [ -f "$root/etc/skein/ddn.yaml" ] || fail "what was kept or set is gone with the programs"
chroot "$root" apt-get purge -y skein >"$log" 2>&1 || fail "purge"
left=$(chroot "$root" find / -xdev -name '*skein*' -not -path '/tmp/*' -not -path '/var/lib/apt/*' | head)
[ -z "$left" ] || fail "left after purge: $left"
said "all held"
