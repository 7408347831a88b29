#!/usr/bin/env bash
# check_network.sh BUILD CASE: two machines (network namespaces joined by a cable that carries no
# multicast), the ground station and the simulator on one, the UAVs on the other, play a mission.
#   peers      each names the other's address; nobody sends a multicast packet
#   one-sided  only the UAVs know where the ground station is
#   strangers  nobody names anybody: they do not meet (so it is the peers that make them)
#   server     a Fast DDS discovery server on the ground's machine (skipped without that program)
#   secured    as peers, with keys
#   multicast  the cable carries multicast, and nobody names anybody: the commands of docs/deploy.md, "Several machines"
#   no-carrier the cable is not plugged in: the daemon says so and ends, and does not wait for ever on an interface DDS left out
# Ends with 77 where namespaces cannot be made.
set -euo pipefail
build=$1 case=$2
if [ -z "${SKEIN_IN_NAMESPACE:-}" ]; then
  unshare -rn true 2>/dev/null || { echo "SKIPPED: no network namespaces here"; exit 77; }
  SKEIN_IN_NAMESPACE=1 exec unshare -rnm "$0" "$@"
fi
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scenario=$here/../../scenarios/karma/detection.yaml
work=$(mktemp -d)
running=()
stop() { [ ${#running[@]} -eq 0 ] || kill -KILL "${running[@]}" 2>/dev/null || true; rm -rf "$work"; }
trap stop EXIT
fail() { echo "FAILED ($case): $*" >&2; tail -n 5 "$work"/*.log >&2 || true; exit 1; }

unshare -n sleep infinity &
other=$!
running+=("$other")
until [ "$(readlink "/proc/$other/ns/net")" != "$(readlink /proc/self/ns/net)" ]; do :; done
on_uavs() { nsenter -t "$other" -n -- "$@"; }
# The discovery server is stopped without ceremony; what it leaves in shared memory is nobody else's.
mount -t tmpfs none /dev/shm
ip link set lo up
ip link add cable type veth peer name end netns "$other"
ip link set cable multicast off
ip addr add 10.77.0.1/24 dev cable
ip link set cable up
on_uavs ip link set end multicast off
on_uavs ip addr add 10.77.0.2/24 dev end
on_uavs ip link set lo up
on_uavs ip link set end up
until ip link show cable | grep -q LOWER_UP && on_uavs ip link show end | grep -q LOWER_UP; do sleep 0.05; done
multicast_sent() { awk '/^IpExt:/ {if (!n++) {for (i = 1; i <= NF; i++) if ($i == "OutMcastPkts") at = i} else print $at}' /proc/net/netstat; }
export -f multicast_sent

if [ "$case" = no-carrier ]; then
  on_uavs ip link set end down
  until ip link show cable | grep -q NO-CARRIER; do sleep 0.05; done
  code=0; timeout 30 "$build/bin/skein-ground" --scenario "$scenario" --interface 10.77.0.1 >"$work/ground.log" 2>&1 || code=$?
  [ "$code" = 3 ] || fail "exit code $code"
  grep -q "no interface that is up has address 10.77.0.1" "$work/ground.log" || fail "it does not say why"
  exit
fi
if [ "$case" = multicast ]; then
  ip link set cable multicast on
  on_uavs ip link set end multicast on
fi

ground=(--multicast off) uavs=(--multicast off)
case $case in
  peers) ground+=(--peer 10.77.0.2) uavs+=(--peer 10.77.0.1) ;;
  one-sided) uavs+=(--peer 10.77.0.1) ;;
  strangers) ;;
  multicast) ground=() uavs=() ;;
  server)
    command -v fast-discovery-server >/dev/null || { echo "SKIPPED: no fast-discovery-server (fastdds-tools)"; exit 77; }
    fast-discovery-server -i 0 -l 10.77.0.1 -p 11811 >"$work/server.log" 2>&1 &
    running+=($!)
    # The server answers programs of its own machine on the loopback interface.
    ground+=(--interface 127.0.0.1 --discovery-server 10.77.0.1:11811) uavs+=(--discovery-server 10.77.0.1:11811) ;;
  secured)
    "$here/../../scripts/make-keys" "$work/keys" "$scenario" --programs "$build/bin" >/dev/null
    ground+=(--peer 10.77.0.2 --security "$work/keys") uavs+=(--peer 10.77.0.1 --security "$work/keys/karma") ;;
  *) echo "unknown case $case" >&2; exit 2 ;;
esac
common=(--scenario "$scenario" --rate 60)
"$build/bin/skein-sim" "${common[@]}" --interface 10.77.0.1 "${ground[@]}" >"$work/sim.log" 2>&1 & sim=$!
"$build/bin/skein-ground" "${common[@]}" --interface 10.77.0.1 "${ground[@]}" >"$work/ground.log" 2>&1 & station=$!
# The daemon itself, so that it is what is stopped.
(exec nsenter -t "$other" -n -- "$build/bin/skein-ddn" "${common[@]}" --uav karma --interface 10.77.0.2 "${uavs[@]}") \
  >"$work/karma.log" 2>&1 & karma=$!
running+=("$sim" "$station" "$karma")

if [ "$case" = strangers ]; then
  # Longer than the others need to meet; that they never do cannot be waited for.
  code=0; timeout 6 tail --pid="$sim" -f /dev/null || code=$?
  [ "$code" = 124 ] || fail "a daemon ended"
  ! grep -q "mission started" "$work/sim.log" || fail "they met"
  exit 0
fi
for one in "$sim" "$station" "$karma"; do
  timeout 60 tail --pid="$one" -f /dev/null || fail "no end after 60 s"
  wait "$one" || fail "exit code $?"
done
grep -q "mission started" "$work/sim.log" || fail "no mission"
[ "$case" != multicast ] || exit 0
[ "$(multicast_sent)" = 0 ] || fail "$(multicast_sent) multicast packets on the ground's machine"
[ "$(on_uavs bash -c multicast_sent)" = 0 ] || fail "multicast packets on the UAV's machine"
