#!/usr/bin/env bash
# run_bulk.sh MACHINE ELF DIR: replays DIR/in.bin into DIR/out.bin with the bulk image on QEMU's
# MACHINE. Exit code as run_semihosted.sh.
set -euo pipefail
(($# == 3)) || { echo "usage: run_bulk.sh MACHINE ELF DIR" >&2; exit 2; }

start_us=${EPOCHREALTIME/./}
"$(dirname "$0")/run_semihosted.sh" "$@"
elapsed_us=$((${EPOCHREALTIME/./} - start_us))

frames=$(($(stat -Lc %s "$3/in.bin") / 16))
echo "$1 bulk: $frames frames in $((elapsed_us / 1000)) ms," \
  "$((frames * 1000000 / elapsed_us)) frames/s"
