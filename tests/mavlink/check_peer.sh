#!/usr/bin/env bash
# Our MAVLink against an independent implementation, node-mavlink (LGPL, from npm, used by this test alone
# and not kept). Skipped (77) where node, npm or the registry are not there.
#   check_peer.sh PROGRAMS      where say_messages is
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
skip() { echo "skipped: $1"; exit 77; }
command -v node >/dev/null || skip "no node"
command -v npm >/dev/null || skip "no npm"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$here/check_peer.js" "$folder"
(cd "$folder" && timeout 100 npm install --no-audit --no-fund --silent --prefer-offline \
  node-mavlink@2.3.0 mavlink-mappings@1.0.21-20250824-1 >/dev/null 2>&1) || skip "npm does not reach the packages"
"$1/skein_mavlink_say_messages" | node "$folder/check_peer.js"
