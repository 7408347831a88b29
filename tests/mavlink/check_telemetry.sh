#!/usr/bin/env bash
# A mission with its daemons over DDS, and what a ground station of others would hear of it, read by
# node-mavlink and compared with where the vehicles truly were. Skipped (77) where that cannot be had.
#   check_telemetry.sh PROGRAMS SCENARIO
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=/dev/null
source "$here/install_peer.sh"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$here/check_telemetry.js" "$folder"
install_peer "$folder"
node "$folder/check_telemetry.js" "$1/skein" "$2" "$folder/run"
