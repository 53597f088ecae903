#!/usr/bin/env bash
# rv32_matches_pc.sh IMAGES FOGCOMP IN.bin MAKE_VECTORS GOLDEN DIR: compiled for RV32, on QEMU's virt machine, the
# bulk image and the product send what fogcomp replay predicts, to the byte; the core's checks find what they find
# elsewhere; a crash ends in a restart that says so. Skipped without the second cross compiler or emulator: it is no
# board of ours, but what holds on a third instruction set is the code's own doing.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
images=$1 fogcomp=$2 input=$3 make_vectors=$4 golden=$5 folder=$6
here=$(realpath "$(dirname "$0")")
for program in riscv64-unknown-elf-g++ qemu-system-riscv32; do
  command -v "$program" >/dev/null || { echo "skipped: no $program"; exit 77; }
done
"$here/build_firmware.sh" rv32_virt "$images"
"$here/bulk_matches_pc.sh" virt "$images/rv32_virt" "$fogcomp" "$input" "$folder/bulk"
"$here/core_check.sh" virt "$images/rv32_virt/core_check.elf" "$make_vectors" "$golden" "$folder/core_check"
head -c 32000 "$input" >"$folder/uart.in"
"$here/uart_matches_pc.sh" virt "$images/rv32_virt" "$fogcomp" "$folder/uart.in" "$folder/uart"
"$here/rv32_restarts.sh" "$images/rv32_virt/fogcomp.elf"
