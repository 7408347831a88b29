#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs one IDL compiler, so that whatever goes wrong fails the build:
#   generate.sh fastddsgen|idlc SOURCE_DIR OUTPUT_DIR FILE.idl…
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
  *)
    echo "unknown IDL compiler $tool" >&2
    exit 2
    ;;
esac
if [ "$status" -ne 0 ] || grep -q -i -e error -e exception "$log"; then
  cat "$log" >&2
  exit 1
fi
