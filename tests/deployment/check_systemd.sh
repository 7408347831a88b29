#!/usr/bin/env bash
# check_systemd.sh BUILD: systemd itself, as the first process of a clean Debian 12 with the package installed, runs the
# daemons of COMETS by their units, as docs/deploy.md tells a user to: they get ready and fly the mission to its end; one
# that crashes and one that stands still come back with what they knew; one that is refused its input stays down and says
# why; each can write its own folder and nothing else. Needs root, mmdebstrap, a Debian mirror and cgroups.
# shellcheck disable=SC2016  # what stands in single quotes is for other shells
set -euo pipefail
build=$(cd "$1" && pwd)
source "$(dirname "${BASH_SOURCE[0]}")/clean_root.sh"
root=$work/root
said() { echo "systemd: $*"; }
first= # process id of its systemd, seen from here

# ---- a machine of its own ----

group=/sys/fs/cgroup
[ ! -d "$group/systemd" ] || group=$group/systemd
group=$group/skein-$$
mkdir "$group" 2>/dev/null || skip "no cgroups"
# shellcheck disable=SC2317  # called by the trap
stop() {
  [ -z "$first" ] || kill -KILL "$first" 2>/dev/null || true
  timeout 10 bash -c 'until [ -z "$(find "$1" -name cgroup.procs -exec cat {} +)" ]; do :; done' _ "$group" || true
  find "$group" -depth -type d -exec rmdir {} + 2>/dev/null || true
  rm -rf --one-file-system "$work"
}
trap stop EXIT

# In namespaces of its own, and not by chroot: the kernel makes no users' namespaces below one.
cat >"$work/boot" <<'SH'
set -e
echo $$ >"$2/cgroup.procs"
exec unshare -nmpuiC --fork --kill-child bash -c '
  mount --make-rprivate / && mount --bind "$1" "$1" && cd "$1"
  mount -t proc proc proc && mount -t sysfs -o ro sysfs sys && mount -t tmpfs tmpfs run && mount -t tmpfs tmpfs dev/shm
  if [ -d /sys/fs/cgroup/systemd ]; then
    mount -t tmpfs tmpfs sys/fs/cgroup && mkdir sys/fs/cgroup/systemd
    mount -t cgroup -o none,name=systemd cgroup sys/fs/cgroup/systemd
  else
    mount -t cgroup2 cgroup2 sys/fs/cgroup
  fi
  ip link set lo up
  mkdir -p mnt/here && pivot_root . mnt/here && umount -l /mnt/here
  exec env -i container=other PATH=/usr/sbin:/usr/bin:/sbin:/bin /lib/systemd/systemd --log-target=journal --show-status=false --unit=multi-user.target
' _ "$1"
SH
inside() { nsenter -t "$first" -m -p -n -u -i -C -r -w "$@"; }
until_is() { # SECONDS WHAT COMMAND…: its output is that
  local seconds=$1 what=$2 end
  shift 2
  end=$((SECONDS + seconds))
  until [ "$("$@" 2>/dev/null)" = "$what" ]; do
    [ "$SECONDS" -lt "$end" ] || { inside journalctl --no-pager -n 40 >"$log" 2>&1; fail "after $seconds s '$*' is not '$what' but '$("$@" 2>&1)'"; }
  done
}
of() { inside systemctl show --value -p "$2" "$1"; } # UNIT PROPERTY
journal_has() { # UNIT TEXT
  inside journalctl -u "$1" --no-pager -o cat >"$log" 2>&1
  grep -q "$2" "$log" || fail "$1 does not say '$2'"
}

make_packages -D CPACK_COMPONENTS_ALL=runtime
make_root "$root" --include=systemd,systemd-sysv
for unit in console-getty getty@ getty-static; do ln -sf /dev/null "$root/etc/systemd/system/$unit.service"; done
bash "$work/boot" "$root" "$group" >"$work/boot.log" 2>&1 &
child=$!
until_started() {
  local of_unshare
  of_unshare=$(cat "/proc/$child/task/$child/children") || return 1
  first=${of_unshare%% *}
  [ -n "$first" ] && [ "$(cat "/proc/$first/comm" 2>/dev/null)" = systemd ]
}
end=$((SECONDS + 30))
until until_started; do [ "$SECONDS" -lt "$end" ] || { log=$work/boot.log; fail "systemd does not start"; }; done
until_is 60 active inside systemctl is-active multi-user.target
said "$(inside systemctl --version | head -n 1) runs"

# ---- the mission, as docs/deploy.md has it ----

daemons=(skein-ground skein-sim skein-ddn@marvin skein-ddn@heliv skein-ddn@karma)
for file in ground sim ddn; do echo "rate: 10" >>"$root/etc/skein/$file.yaml"; done
inside systemctl enable --now "${daemons[@]}" >"$log" 2>&1 || fail "enable --now"
for one in "${daemons[@]}"; do until_is 30 "mission running" of "$one" StatusText; done
said "all are ready, and the mission runs"

comes_back() { # UNIT SECONDS HOW
  until_is "$2" 1 of "$1" NRestarts
  until_is 20 "mission running" of "$1" StatusText
  journal_has "$1" "resumed (from"
  said "$1 $3 and came back with what it knew"
}
inside systemctl kill -s KILL skein-ddn@heliv
comes_back skein-ddn@heliv 10 "was killed"
inside systemctl kill -s STOP skein-ddn@karma
comes_back skein-ddn@karma 20 "stood still"

# ---- what each can do ----

main=$(of skein-ddn@marvin MainPID)
status=$(inside cat "/proc/$main/status")
for line in "CapEff:.0000000000000000" "CapBnd:.0000000000000000" "NoNewPrivs:.1" "Seccomp:.2"; do
  grep -q "^$line" <<<"$status" || fail "the process has not '$line'"
done
account=$(inside id -u skein)
as_marvin() { inside nsenter -t "$main" -m -U -S "$account" "$@" >"$log" 2>&1; }
as_marvin touch /var/lib/skein/marvin/probe || fail "its own folder cannot be written"
for file in /usr/probe /etc/skein/probe /var/lib/skein/probe /var/lib/skein/ground/probe; do
  ! as_marvin touch "$file" || fail "$file can be written"
  grep -q "Read-only file system" "$log" || fail "$file: not for being read-only"
done
for folder in /home /root /var/lib/private; do ! as_marvin ls "$folder" || fail "$folder can be read"; done
! as_marvin test -e /dev/sda || fail "disks are there"
said "a daemon writes its own folder and no other"

# ---- the end ----

for one in "${daemons[@]}"; do
  until_is 180 inactive of "$one" ActiveState
  [ "$(of "$one" Result)" = success ] || fail "$one: $(of "$one" Result)"
done
journal_has skein-ground "mission finished"
said "the mission was flown, and all stopped"

# ---- the next one with keys, as docs/threats.md has it ----

inside skein-make-keys /root/keys /usr/share/skein/scenarios/comets/confirmed.yaml >"$log" 2>&1 || fail "keys"
inside install -d -o root -g skein -m 750 /etc/skein/keys
for node in ground sim marvin heliv karma; do
  inside install -d -o root -g skein -m 750 "/etc/skein/keys/$node"
  inside bash -c 'install -o root -g skein -m 640 "/root/keys/$1"/* "/etc/skein/keys/$1"' _ "$node"
done
for file in ground sim ddn; do echo "security: /etc/skein/keys" >>"$root/etc/skein/$file.yaml"; done
inside systemctl start "${daemons[@]}" >"$log" 2>&1 || fail "start with keys"
for one in "${daemons[@]}"; do until_is 90 "mission running" of "$one" StatusText; done
inside chmod 600 /etc/skein/keys/heliv/key.pem
! inside systemctl restart skein-ddn@heliv >"$log" 2>&1 || fail "it takes part without its key"
journal_has skein-ddn@heliv "cannot read the keys in /etc/skein/keys/heliv: key.pem"
# What the machine lacks may come (docs/exit-codes.md, 3): it is tried again.
inside chmod 640 /etc/skein/keys/heliv/key.pem
until_is 30 active of skein-ddn@heliv ActiveState
inside systemctl stop "${daemons[@]}"
said "with keys they meet; one that cannot read its own says so, and takes part once it can"
echo "domian: 8" >>"$root/etc/skein/sim.yaml"
! inside systemctl start skein-sim >"$log" 2>&1 || fail "a wrong file is taken"
until_is 10 failed of skein-sim ActiveState
[ "$(of skein-sim ExecMainStatus) $(of skein-sim NRestarts)" = "2 0" ] || fail "it is not left down with 2"
journal_has skein-sim "sim.yaml:.*domian"
said "all held"
