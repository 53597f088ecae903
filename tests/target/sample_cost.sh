#!/usr/bin/env bash
# sample_cost.sh ELF DIR MOST IN.bin...: no 16 bytes in a row of these sensor streams, which is what comes in the
# time of a sample, cost the board more than MOST instructions, all stages, frames, health and self-test included.
# QEMU counts one tick of the timer per instruction; they are not cycles. FOG_TABLE: of the generic image, ADDRESS=FILE.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
elf=$(realpath "$1") folder=$2 max=$3
shift 3
mkdir -p "$folder"
for input in "$@"; do
  ln -sf "$(realpath "$input")" "$folder/in.bin"
  console=$(cd "$folder" && timeout --kill-after=1 170 qemu-system-arm -M netduinoplus2 -display none -monitor none \
    -icount shift=0,sleep=off -semihosting-config enable=on,target=native \
    ${FOG_TABLE:+-device "loader,addr=${FOG_TABLE%%=*},file=$(realpath "${FOG_TABLE#*=}"),force-raw=on"} \
    -serial null -serial null -serial stdio -kernel "$elf" </dev/null | tr -d '\r')
  [[ $console =~ samples:\ count\ ([0-9]+)\ mean\ ([0-9]+)\ max\ ([0-9]+) ]]
  count=${BASH_REMATCH[1]} mean=${BASH_REMATCH[2]} sample=${BASH_REMATCH[3]}
  [[ $console =~ any\ 16\ bytes:\ count\ [0-9]+\ mean\ ([0-9]+)\ max\ ([0-9]+) ]]
  bytes_mean=${BASH_REMATCH[1]} bytes_max=${BASH_REMATCH[2]}
  [[ $console =~ self-test:\ count\ [0-9]+\ mean\ ([0-9]+)\ max\ ([0-9]+) ]]
  echo "${input##*/}: $count samples, to complete one mean $mean max $sample (self-test mean ${BASH_REMATCH[1]}" \
    "max ${BASH_REMATCH[2]}); 16 bytes mean $bytes_mean max $bytes_max of $max instructions"
  ((count > 1000 && bytes_max <= max))
done
