# shellcheck shell=bash
# A clean Debian 12 with the packages of a build tree, for the checks of this folder: sourced, with `build` set. `work` is
# their folder, `log` what the last command had to say.
# shellcheck disable=SC2016  # what stands in single quotes is for other shells
skip() { echo "SKIPPED: $*"; exit 77; }
fail() { tail -n 30 "$log" >&2; echo "FAILED: $*" >&2; exit 1; }
[ "$(id -u)" -eq 0 ] || skip "not root"
command -v mmdebstrap >/dev/null || skip "no mmdebstrap"
work=$(mktemp -d /var/tmp/skein-packages.XXXXXX)
log=$work/log
# What mmdebstrap may still have mounted there, when it is stopped in the middle, is the machine's own.
trap 'rm -rf --one-file-system "$work"' EXIT

# Of the time of a loaded machine these took most: xz packs 180 MB in a minute of processor time (gzip in five seconds),
# and dpkg waits for the disk after each file.
make_packages() { # [option of cpack]…: into $work/packages
  (cd "$build" && cpack "$@" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip -B "$work/packages") >"$log" 2>&1 || fail "cpack"
}
make_root() { # ROOT [option of mmdebstrap]…: with the package skein
  local root=$1 sources install
  shift
  sources=$(find /etc/apt/sources.list.d -name '*.sources' -o -path '*debian.list' | head -n 1)
  [ -s "${sources:-/etc/apt/sources.list}" ] || skip "no list of Debian mirrors"
  install='cd "$1/tmp" && chroot "$1" sh -c "cd /tmp && apt-get install -q -y --no-install-recommends ./skein_*.deb openssl"'
  mmdebstrap --variant=minbase --dpkgopt=force-unsafe-io --skip=cleanup/apt/lists,cleanup/tmp "$@" \
    --customize-hook="copy-in $(echo "$work"/packages/*.deb) /tmp" --customize-hook="$install" \
    bookworm "$root" "${sources:-/etc/apt/sources.list}" >"$log" 2>&1 ||
    { grep -q 'E: .*\(fetch\|resolve\|connect\)' "$log" && skip "no Debian mirror reached"; fail "installing"; }
}
