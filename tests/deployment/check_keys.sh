#!/usr/bin/env bash
# check_keys.sh BUILD CASE: who has keys takes part, who has not is kept out (docs/threats.md).
#   comets       COMETS over DDS with keys meets its expectations
#   no-keys      a UAV without keys does not meet the others, and a spy without keys hears nothing
#   expired      a certificate that ran out: its node is refused by itself, and, where that has a wrong
#                clock, by the others (skipped before the latter where faketime is not installed)
#   runs-out     a certificate that runs out while its node takes part: it goes on, and is refused when it starts again
#   stalled      a UAV that stands still for 7 s while it shakes hands takes part afterwards
#   unmet        a UAV stands still while it shakes hands, until another takes part anew; they meet afterwards
#   other-name   a UAV with another's keys is refused
#   other-slots  a UAV whose permissions lack a slot is refused
set -euo pipefail
build=$1 case=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scenarios=$here/../../scenarios
rate=60
source "$here/daemons.sh"
keys() { "${prefix[@]}" "$here/../../scripts/make-keys" "$work/keys" "$1" --programs "$build/bin" >"$work/keys.log"; }

if [ "$case" = comets ]; then
  keys "$scenarios/comets/confirmed.yaml"
  "$build/bin/skein" run "$scenarios/comets/confirmed.yaml" --security "$work/keys" --out "$work/out" --quiet
  exit
fi

# A network of its own, so that the domain is free.
if [ -z "${SKEIN_IN_NAMESPACE:-}" ]; then
  unshare -rn true 2>/dev/null || { echo "SKIPPED: no network namespaces here"; exit 77; }
  rm -rf "$work"
  SKEIN_IN_NAMESPACE=1 exec unshare -rnm "$0" "$@"
fi
ip link set lo up
# The authority of this case was good when the certificate was.
if [ "$case" = expired ] && command -v faketime >/dev/null; then prefix=(faketime '-2 days'); fi
scenario=$scenarios/karma/detection.yaml
keys "$scenario"
prefix=()
refused() { # WHAT PROGRAM [options]: it ends with 3 and says so
  local what=$1 code=0
  shift
  timeout 30 "$build/bin/$1" --scenario "$scenario" "${@:2}" >"$work/refused.log" 2>&1 || code=$?
  [ "$code" = 3 ] || fail "exit code $code"
  grep -q "$what" "$work/refused.log" || fail "not '$what'"
}
never_started() { # after the time in which others meet
  local code=0
  timeout 6 tail --pid="$1" -f /dev/null || code=$?
  [ "$code" = 124 ] || fail "a daemon ended"
  ! grep -q "mission started" "$work/sim.log" || fail "they met"
}
start_stopped_in_handshake() { # karma, which the others have heard of, and which stands still before its first message of a handshake
  prefix=(env LD_PRELOAD="$build/lib/libskein_adversity.so" ADVERSITY_HANDSHAKE=1)
  start karma skein-ddn --uav karma --security "$work/keys/karma"
  prefix=()
  timeout 40 bash -c 'until grep -q "^State:.T" "/proc/$1/status"; do timeout 0.05 tail -f /dev/null || true; done' _ "$last" || fail "there is no handshake"
}
certified() { # FROM UNTIL: a certificate for karma, good between these (as date takes them)
  mkdir "$work/ca"
  : >"$work/ca/index"
  printf '[ca]\ndefault_ca=it\n[it]\ndatabase=%s\nnew_certs_dir=%s\nrand_serial=yes\npolicy=any\n[any]\norganizationName=supplied\ncommonName=supplied\n' \
    "$work/ca/index" "$work/ca" >"$work/ca/config"
  openssl req -new -key "$work/keys/karma/key.pem" -subj "/O=Skein/CN=karma" -out "$work/ca/request.pem" 2>"$work/openssl.log"
  openssl ca -batch -notext -config "$work/ca/config" -md sha256 -cert "$work/keys/authority/ca.pem" -keyfile "$work/keys/authority/key.pem" \
    -extfile <(echo basicConstraints=critical,CA:FALSE) -startdate "$(date -u -d "$1" +%Y%m%d%H%M%SZ)" -enddate "$(date -u -d "$2" +%Y%m%d%H%M%SZ)" \
    -in "$work/ca/request.pem" -out "$work/keys/karma/cert.pem" 2>"$work/openssl.log" || fail "openssl ca"
}

case $case in
  no-keys)
    start sim skein-sim --security "$work/keys"
    start ground skein-ground --security "$work/keys"
    start karma skein-ddn --uav karma
    never_started "$last"
    code=0; "$build/bin/skein" spy --duration 2 >"$work/spy.log" 2>&1 || code=$?
    grep -q karma "$work/spy.log" || fail "the spy does not even hear karma"
    ! grep -qE 'ground|sim' "$work/spy.log" || fail "the spy heard who has keys" ;;
  expired)
    certified "-47 hours" "-24 hours"
    refused "refuses the keys" skein-ddn --uav karma --security "$work/keys"
    command -v faketime >/dev/null || { echo "SKIPPED: there is no faketime here, a node with a wrong clock is not tried"; exit 77; }
    start sim skein-sim --security "$work/keys"
    start ground skein-ground --security "$work/keys"
    prefix=(env FAKETIME_DONT_FAKE_MONOTONIC=1 faketime '-36 hours')
    start karma skein-ddn --uav karma --security "$work/keys"
    never_started "$last"
    grep -q "certificate has expired" "$work/ground.log" || fail "the ground station does not say why" ;;
  runs-out)
    rate=2
    runs_out=$(($(date +%s) + 30))
    certified "-1 hour" "@$runs_out"
    start sim skein-sim --security "$work/keys"
    start ground skein-ground --security "$work/keys"
    start karma skein-ddn --uav karma --security "$work/keys"
    timeout 25 grep -q "mission started" <(tail -n +1 -f "$work/sim.log") || fail "they did not meet"
    [ "$(date +%s)" -lt "$runs_out" ] || fail "it ran out before they met: nothing is shown"
    until [ "$(date +%s)" -gt "$((runs_out + 5))" ]; do timeout 1 tail -f /dev/null || true; done
    heard=$(wc -l <"$work/sim.log")
    timeout 90 grep -q "vehicle karma: .* running" <(tail -n +$((heard + 1)) -f "$work/sim.log") || fail "nothing that karma asks for is done any more"
    kill -KILL "$last"
    refused "refuses the keys" skein-ddn --uav karma --security "$work/keys" ;;
  stalled)
    start sim skein-sim --security "$work/keys/sim"
    start ground skein-ground --security "$work/keys/ground"
    start_stopped_in_handshake
    timeout 7 tail -f /dev/null || true
    kill -CONT "$last"
    timeout 40 grep -q "mission started" <(tail -f "$work/sim.log") || fail "they did not meet" ;;
  unmet)
    start sim skein-sim --security "$work/keys/sim"
    start ground skein-ground --security "$work/keys/ground"
    start_stopped_in_handshake
    anew="the handshake with karma does not end: it takes part anew"
    timeout 40 grep -q "$anew" <(tail -n +1 -f "$work/sim.log") || fail "the simulator goes on with a handshake that does not end"
    kill -CONT "$last"
    timeout 40 grep -q "mission started" <(tail -n +1 -f "$work/sim.log") || fail "they did not meet" ;;
  other-name)
    refused "do not allow" skein-ground --security "$work/keys/karma" ;;
  other-slots)
    cat >"$work/skein-ground" <<SH
#!/bin/sh
"$build/bin/skein-ground" "\$@" | grep -v '^karma publish .* Telemetry\$'
SH
    chmod +x "$work/skein-ground"
    "$here/../../scripts/make-keys" "$work/keys" "$scenario" --programs "$work" >"$work/keys.log"
    refused "do not allow" skein-ddn --uav karma --security "$work/keys" ;;
  *) echo "unknown case $case" >&2; exit 2 ;;
esac
