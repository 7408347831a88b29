#!/usr/bin/env bash
# check_boot.sh BUILD CASE: a UAV that dies and loses its memory boots with a clock that says 1970 (docs/daemons.md).
#   counted      with --state its incarnations are counted on, and the ground station hears it
#   clock        without, it has the number of an older incarnation, is told which one it is, and is heard (decision 36)
set -euo pipefail
build=$1 case=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
command -v faketime >/dev/null || { echo "SKIPPED: there is no faketime here"; exit 77; }
# A network of its own, so that the domain is free.
if [ -z "${SKEIN_IN_NAMESPACE:-}" ]; then
  unshare -rn true 2>/dev/null || { echo "SKIPPED: no network namespaces here"; exit 77; }
  SKEIN_IN_NAMESPACE=1 exec unshare -rnm "$0" "$@"
fi
ip link set lo up
scenario=$here/../../scenarios/karma/detection.yaml rate=2
source "$here/daemons.sh"
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
