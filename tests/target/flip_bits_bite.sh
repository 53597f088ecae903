#!/usr/bin/env bash
# flip_bits_bite.sh PROGRAMS MACHINE ELF: the programs of flip_bits.sh see a board that is none the worse: a bit
# behind the image belongs to nothing, and both must say that it changed nothing.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
programs=$1 machine=$2 elf=$3
end=0x$(arm-none-eabi-nm "$elf" | awk '$3 == "fog_image_end" { print $1 }')
expect_refusal() {
  local status=0
  "$@" || status=$?
  ((status == 1)) || fail "exit code $status, not 1: $*"
}
expect_refusal "$programs/boot_flips" "$machine" "$elf" 1 120 "behind:$end:4:2"
expect_refusal "$programs/running_flips" "$machine" "$elf" 1 2000 "behind:$end:4:1"
