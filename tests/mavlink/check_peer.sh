#!/usr/bin/env bash
# Our MAVLink against an independent implementation, node-mavlink. Skipped (77) where it cannot be had.
#   check_peer.sh PROGRAMS      where say_messages is
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=/dev/null
source "$here/install_peer.sh"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$here/check_peer.js" "$folder"
install_peer "$folder"
"$1/skein_mavlink_say_messages" | node "$folder/check_peer.js"
