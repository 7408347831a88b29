# shellcheck shell=bash
# node-mavlink (LGPL, from npm, used by tests alone and not kept) into a folder. Ends the test as skipped (77)
# where node, npm or the registry are not there.
skip() { echo "skipped: $1"; exit 77; }
install_peer() {
  command -v node >/dev/null || skip "no node"
  command -v npm >/dev/null || skip "no npm"
  (cd "$1" && timeout 100 npm install --no-audit --no-fund --silent --prefer-offline \
    node-mavlink@2.3.0 mavlink-mappings@1.0.21-20250824-1 >/dev/null 2>&1) || skip "npm does not reach the packages"
}
