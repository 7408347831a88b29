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
# Tests in real time (label dds; here `late` and `radio`) run in a pass of their own and are tried once more, other tests never.
cat >"$room/ctest" <<'END'
#!/bin/sh
echo ctest "$@" >>called
case "$*" in
  *' -N '*) echo '  Test  #7: late'; echo '  Test #12: radio'; exit 0 ;;
  *' -R '*) exit "$again" ;;
esac
case "$*" in *'-L dds'*) pass=real ;; *) pass=pure ;; esac
mkdir -p "$2/Testing/Temporary"
for name in $failing; do
  case $name in late|radio) of=real ;; *) of=pure ;; esac
  [ "$of" != "$pass" ] || echo "7:$name"
done >"$2/Testing/Temporary/LastTestsFailed.log"
[ ! -s "$2/Testing/Temporary/LastTestsFailed.log" ]
END
chmod +x "$room/ctest"
attempt() { # FAILING CODE-OF-THE-SECOND EXPECTED-CODE
  export failing=$1 again=$2
  PATH=$room:$PATH try check
  [ "$code" = "$3" ] || fail "check with '$1' failing, then $2: exit code $code: $said"
}
attempt '' 1 0
grep -q -- ' -R ' <<<"$called" && fail "check: a second attempt of nothing"
for pass in '--test-dir build .*-LE packages|dds' '--test-dir build/real-time .*-L dds'; do
  grep -q -- "$pass" <<<"$called" || fail "check: no pass '$pass': $called"
done
attempt 'late radio' 0 0
grep -qF -- '-R ^(late|radio)$' <<<"$called" || fail "check: the second attempt: $called"
grep -qx 'skein: passed at the second attempt only: late radio' <<<"$said" || fail "check: not said: $said"
attempt 'late' 1 1
attempt 'late planner' 0 1
attempt 'late radio late radio late radio late radio late radio late' 0 1
echo "the entries say and do what they should"
