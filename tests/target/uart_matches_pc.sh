#!/usr/bin/env bash
# uart_matches_pc.sh MACHINE IMAGES FOGCOMP IN.bin DIR: the product image of the folder IMAGES, booted and
# fed through its serial ports, sends for IN.bin what fogcomp replay predicts, to the byte.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
machine=$1 images=$2 fogcomp=$3 input=$4 folder=$5
mkdir -p "$folder"
"$fogcomp" replay "$images/model/fog_model.h" "$input" -o "$folder/expected.bin"
"$(dirname "$0")/run_uart.sh" "$machine" "$images/fogcomp.elf" "$input" "$folder/out.bin" \
  "$(stat -c %s "$folder/expected.bin")"
same_bytes "$folder/expected.bin" "$folder/out.bin"
