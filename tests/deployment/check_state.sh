#!/usr/bin/env bash
# check_state.sh BUILD CASE: a decision node comes back to a state file that is not to be gone on from, or cannot keep one
# (docs/daemons.md): it says why, and flies.
#   other-node      the file of another node
#   other-scenario  of another scenario
#   newer           of a newer version
#   half            half a file
#   other-program   of a program that did something else: it shows only when the node is given what is in it
#   other-bytes     a number in it that the disk gave back as another
#   in-use          the node runs already: the second process ends at once, and nobody hears of it
#   read-only       a folder in which nothing can be written
#   full            a disk that is full from the first minute on
#   full-for-a-time the same, and after a minute it has room again: nothing is missing then
set -euo pipefail
build=$1 case=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# A network of its own, so that the domain is free, and mounts of its own.
if [ -z "${SKEIN_IN_NAMESPACE:-}" ]; then
  unshare -rnm true 2>/dev/null || { echo "SKIPPED: no namespaces here"; exit 77; }
  SKEIN_IN_NAMESPACE=1 exec unshare -rnm "$0" "$@"
fi
ip link set lo up
scenario=$here/../../scenarios/karma/detection.yaml rate=40
source "$here/daemons.sh"
mkdir "$work/state"
trap 'umount "$work/state" 2>/dev/null || true; stop' EXIT
karma() { : >"$work/$1.log"; start "$1" skein-ddn --uav karma --state "$work/state"; }  # NAME of its log
says() { # LOG TEXT [SECONDS]
  timeout "${3:-30}" grep -q "$2" <(tail -n +1 -f "$work/$1.log") || fail "$1 does not say '$2'"
}
to_the_end() { # all of them, and well
  for one in "${running[@]}"; do
    timeout 60 tail --pid="$one" -f /dev/null || fail "no end after 60 s"
    code=0; wait "$one" || code=$?
    [ "$code" = 0 ] || fail "exit code $code"
  done
  grep -q "landed" "$work/karma.log" || grep -q "land .* ended" "$work/karma.log" || fail "karma did not land"
}
sql() { python3 -c 'import sqlite3, sys; print(sqlite3.connect(sys.argv[1], isolation_level=None).execute(sys.argv[2]).fetchone())' "$@"; }

: >"$work/sim.log"
: >"$work/ground.log"
start sim skein-sim --state "$work/of-others"
start ground skein-ground --state "$work/of-others"
case $case in
  read-only)
    mount -t tmpfs -o ro none "$work/state"
    karma karma
    says karma "nothing outlives this process: .*Read-only file system"
    to_the_end
    exit ;;
  full*)
    mount -t tmpfs -o size=128k none "$work/state"
    karma karma
    says karma "what happens is not kept: .*disk is full"
    says karma "takeoff"
    [ "$case" = full ] || mount -o remount,size=8m "$work/state"
    to_the_end
    # Near the edge some small thing may still find room: it is not said at each.
    [ "$(grep -c "what happens is not kept" "$work/karma.log")" -lt 5 ] || fail "it says so again and again"
    last_word=$(grep -o "what happens is .*kept\( again\)\?" "$work/karma.log" | tail -n 1)
    complete=$([ -e "$work/state/karma.complete" ] && echo yes || echo no)
    case $case in
      full) [ "$last_word $complete" = "what happens is not kept no" ] || fail "at the end: $last_word, complete: $complete" ;;
      *) [ "$last_word $complete" = "what happens is kept again yes" ] || fail "at the end: $last_word, complete: $complete" ;;
    esac
    exit ;;
esac

# A first life, of which the state is.
karma first
says sim "mission started"
says first "takeoff"
if [ "$case" = in-use ]; then
  code=0
  timeout 20 "$build/bin/skein-ddn" --uav karma --scenario "$scenario" --rate "$rate" --state "$work/state" >"$work/twice.log" 2>&1 || code=$?
  [ "$code" = 3 ] || fail "the second process ends with $code"
  says twice "karma.state: another process uses it: karma runs already"
  ln -s "$work/first.log" "$work/karma.log"
  to_the_end
  ! grep -q "of this name\|cannot be reached" "$work/first.log" || fail "the first was disturbed"
  exit
fi
kill -KILL "$last"
wait "$last" 2>/dev/null || true
unset 'running[-1]'
file=$work/state/karma.state
case $case in
  other-node)
    rm -f "$work"/state/karma.*
    cp "$work/of-others/ground.state" "$file"
    [ ! -e "$work/of-others/ground.state-wal" ] || cp "$work/of-others/ground.state-wal" "$file-wal"
    why="of node 'ground'" ;;
  other-scenario) sql "$file" "UPDATE about SET value = 'rescue 1' WHERE what = 'mission' RETURNING value"; why="of another scenario" ;;
  newer) sql "$file" "PRAGMA user_version = 99"; why="of version 99, this program reads up to" ;;
  half)
    sql "$file" "PRAGMA wal_checkpoint(TRUNCATE)"
    truncate -s $(($(stat -c %s "$file") / 2)) "$file"
    why="damaged: " ;;
  other-program)
    sql "$file" "UPDATE about SET value = 999999 WHERE what = 'lines' RETURNING value"
    why="" ;;
  other-bytes)
    sql "$file" "UPDATE inputs SET at = at + 1 WHERE number = 5 RETURNING at"
    why="" ;;
  *) echo "unknown case $case" >&2; exit 2 ;;
esac
karma second
case $case in
  other-program) says second "what was kept of karma is not gone on from: .* does not explain the 999999 lines.*; it is .*karma.state.aside-1 now" ;;
  other-bytes) says second "what was kept of karma is not gone on from: .*input 5: not what was written.*; it is .*karma.state.aside-1 now" ;;
  *) says second "karma.state is $why.*; it is .*karma.state.aside-1 now" ;;
esac
says ground "restarted.*karma"
# It goes on keeping, and lives.
until [ "$("$build/bin/skein" state show "$file" --json 2>/dev/null | python3 -c 'import json, sys; print(json.load(sys.stdin)["inputs"] > 20)' 2>/dev/null)" = True ]; do
  kill -0 "$last" 2>/dev/null || fail "it ended"
done
[ -e "$file.aside-1" ] || fail "what was set aside is gone"
