#!/usr/bin/env bash
# Our messages, read by others: npm's @foxglove/rosmsg2-serialization by the definitions of ROS 2 in @foxglove/rosmsg-msgs-common (both MIT,
# used by this test alone and not kept). Skipped (77) where node, npm or the registry are not there.
#   check_peer.sh PROGRAMS
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
programs=$(cd "$1" && pwd)
skip() { echo "skipped: $1"; exit 77; }
command -v node >/dev/null || skip "no node"
command -v npm >/dev/null || skip "no npm"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$here/check_peer.js" "$folder"
cd "$folder"
echo '{"private": true}' >package.json
timeout 100 npm install --no-audit --no-fund --silent --prefer-offline \
  @foxglove/rosmsg-msgs-common@3.2.3 @foxglove/rosmsg2-serialization@3.1.0 >/dev/null 2>&1 || skip "npm does not reach the packages"
"$programs/skein_ros2_say_messages" | node check_peer.js
