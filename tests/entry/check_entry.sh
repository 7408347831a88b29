#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What ./demo and ./check say and ask for, with everything that they call replaced by scripts that write down how they
# were called.
#   check_entry.sh SOURCE
set -euo pipefail
source=$1
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
mkdir -p "$room/scripts" "$room/build/bin"
cp "$source/demo" "$source/check" "$room"
for one in scripts/bootstrap scripts/build build/bin/skein; do
  printf '#!/bin/sh\necho %s "$@" >>called\n' "$one" >"$room/$one"
  chmod +x "$room/$one"
done

fail() { echo "check_entry: $*" >&2; exit 1; }
# Runs it from another folder; then `said` is what it wrote, `code` its exit code, `called` what it called.
try() {
  rm -f "$room/called"
  code=0
  said=$(cd / && "$room/$1" "${@:2}" 2>&1) || code=$?
  called=$(cat "$room/called" 2>/dev/null || true)
}

for words in "demo --help" "demo -h" "demo infirmed --rate 5 --help" "check --help" "check -h" "check --long --help"; do
  read -ra line <<<"$words"
  try "${line[@]}"
  [ "$code" = 0 ] || fail "$words: exit code $code"
  [ -z "$called" ] || fail "$words: it called $called"
  grep -q -- "./${line[0]}" <<<"$said" || fail "$words: no usage in: $said"
  grep -q '^#' <<<"$said" && fail "$words: it shows its source: $said"
done

try demo
grep -qx 'build/bin/skein run scenarios/comets/confirmed.yaml --out out/comets-confirmed' <<<"$called" || fail "demo: $called"
try demo infirmed --rate 5 --unheard-of
grep -qx 'build/bin/skein run scenarios/comets/infirmed.yaml --out out/comets-infirmed --rate 5 --unheard-of' <<<"$called" ||
  fail "demo with options: $called"
[ "$(head -n 1 <<<"$called")" = scripts/bootstrap ] || fail "demo does not begin with what is missing: $called"

try check --unheard-of
[ "$code" = 2 ] || fail "check --unheard-of: exit code $code"
[ -z "$called" ] || fail "check --unheard-of called $called"
echo "the entries say and do what they should"
