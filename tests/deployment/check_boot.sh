#!/usr/bin/env bash
# check_boot.sh BUILD CASE: clocks of machines that are just there. A UAV that dies and loses its memory boots with one that
# says 1970 (docs/daemons.md):
#   counted      with --state its incarnations are counted on, and the ground station hears it
#   clock        without, it has the number of an older incarnation, is told which one it is, and is heard (decision 36)
# One that waits for the others has its clock set back by a day, and meets them all the same:
#   set-back-fastdds, set-back-cyclonedds
set -euo pipefail
build=$1 case=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
[[ $case == set-back-* ]] || command -v faketime >/dev/null || { echo "SKIPPED: there is no faketime here"; exit 77; }
# A network of its own, so that the domain is free.
if [ -z "${SKEIN_IN_NAMESPACE:-}" ]; then
  unshare -rn true 2>/dev/null || { echo "SKIPPED: no network namespaces here"; exit 77; }
  SKEIN_IN_NAMESPACE=1 exec unshare -rnm "$0" "$@"
fi
ip link set lo up
scenario=$here/../../scenarios/karma/detection.yaml rate=2
source "$here/daemons.sh"
if [[ $case == set-back-* ]]; then
  dds=${case#set-back-}
  # In place: the daemons have it mapped, and a file that is cut to nothing first is a bus error to who looks meanwhile.
  shift_by() { python3 -c 'import os, struct, sys; os.pwrite(os.open(sys.argv[1], os.O_RDWR | os.O_CREAT), struct.pack("=q", int(sys.argv[2])), 0)' "$work/shift" "$1"; }
  shift_by 0
  prefix=(env "ADVERSITY_CLOCK=$work/shift" "LD_PRELOAD=$build/lib/libskein_adversity.so")
  start sim skein-sim --dds "$dds"
  prefix=()
  until [ "$(find "/proc/$last/fd" -lname 'socket:*' 2>/dev/null | wc -l)" -ge 4 ]; do kill -0 "$last" || fail "it ended"; done
  shift_by -86400
  timeout 3 tail -f /dev/null || true  # longer than between two of its announcements: the next is due
  start ground skein-ground --dds "$dds"
  start karma skein-ddn --uav karma --dds "$dds"
  timeout 20 grep -q "mission started" <(tail -n +1 -f "$work/sim.log") || fail "they did not meet"
  exit
fi
state=()
[ "$case" = clock ] || state=(--state "$work/state")
start sim skein-sim
start ground skein-ground
start karma skein-ddn --uav karma "${state[@]}"
timeout 40 grep -q "karma can be reached" <(tail -f "$work/ground.log") || fail "they did not meet"
kill -KILL "$last"
rm -f "$work"/state/karma.state* "$work"/state/karma.complete
prefix=(env FAKETIME_DONT_FAKE_MONOTONIC=1 faketime '1970-01-02')
start karma-again skein-ddn --uav karma "${state[@]}"
case $case in
  counted|clock)
    timeout 30 grep -q "restarted.*karma" <(tail -f "$work/ground.log") || fail "it is not heard" ;;
  *) echo "unknown case $case" >&2; exit 2 ;;
esac
