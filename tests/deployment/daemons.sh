# SPDX-License-Identifier: Apache-2.0
# Daemons in the background, for the checks of this folder: sourced, with `build`, `case` and, before the first of them,
# `scenario` and `rate` set. `work` is their folder; `prefix` is put in front of their commands, `last` is the process id
# of the last one. All are killed at the end, with what a prefix may have put before them (faketime stays, and waits).
work=$(mktemp -d)
running=()
prefix=()
set -m  # a process group for each
stop() { [ ${#running[@]} -eq 0 ] || kill -KILL -- "${running[@]/#/-}" 2>/dev/null || true; rm -rf "$work"; }
trap stop EXIT
fail() { echo "FAILED ($case): $*" >&2; tail -n 5 "$work"/*.log >&2 || true; exit 1; }
start() { # NAME PROGRAM [options]
  local name=$1 program=$2
  shift 2
  : >"$work/$name.log"  # there to be followed
  "${prefix[@]}" "$build/bin/$program" --scenario "$scenario" --rate "$rate" "$@" >"$work/$name.log" 2>&1 &
  running+=($!)
  last=$!
}
