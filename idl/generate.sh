#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs one IDL compiler, so that whatever goes wrong fails the build:
#   generate.sh fastddsgen|idlc|types SOURCE_DIR OUTPUT_DIR FILE.idl…
# "types": what idlc says of the types themselves, the bytes of their XTypes TypeInformation and
# TypeMapping, as OUTPUT_DIR/types.inc in C++; docs/decisions/0099 says why the header is no base there.
# fastddsgen may print ERROR or a stack trace and still succeed; idlc may loop for ever eating memory.
set -eu
tool=$1 source=$2 output=$3
shift 3
ulimit -v 16000000 2>/dev/null || true
mkdir -p "$output"
log=$output/$tool.log
status=0
: >"$log"
case $tool in
  fastddsgen)
    (cd "$source" && timeout 120 fastddsgen -cs -replace -I . -d "$output" "$@") >"$log" 2>&1 || status=$?
    ;;
  idlc)
    for file in "$@"; do
      (cd "$output" && timeout 30 idlc -Wno-implicit-extensibility "$source/$file") >>"$log" 2>&1 || status=$?
    done
    ;;
  types)
    for file in "$@"; do
      awk 'FNR == NR { if (/^};/) inside = 0; if (inside) header = header $0 "\n"; if (/^struct SampleHeader/) inside = 1; next }
           sub(/ : SampleHeader/, "") { print; printf "%s", header; next } { print }' \
        "$source/common.idl" "$source/$file" >"$output/$file"
    done
    for file in "$@"; do
      (cd "$output" && timeout 30 idlc -Wno-implicit-extensibility "$file") >>"$log" 2>&1 || status=$?
      sed -n -E -e '/^#define TYPE_(INFO|MAP)_CDR_skein_idl_/,/^\}/ {' \
        -e 's/^#define TYPE_(INFO|MAP)_CDR_skein_idl_(\w+) \(unsigned char \[\]\)\{ \\$/[[maybe_unused]] constexpr unsigned char k\2_\1[] = {/' \
        -e 's/ ?\\$//; s/^\}$/};/; p; }' "$output/${file%.idl}.c"
    done >"$output/types.inc"
    ;;
  *)
    echo "unknown IDL compiler $tool" >&2
    exit 2
    ;;
esac
if [ "$status" -ne 0 ] || grep -q -i -e error -e exception "$log"; then
  cat "$log" >&2
  exit 1
fi
