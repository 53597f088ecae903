#!/usr/bin/env bash
# uart_matches_pc.sh MACHINE ELF IN.bin EXPECTED.bin DIR: the product image, booted and fed through its
# serial ports, turns IN.bin into EXPECTED.bin to the byte.
set -euo pipefail
machine=$1 elf=$2 input=$3 expected=$4 folder=$5
mkdir -p "$folder"
"$(dirname "$0")/run_uart.sh" "$machine" "$elf" "$input" "$folder/uart.bin" \
  "$(stat -c %s "$expected")"
cmp "$expected" "$folder/uart.bin"
