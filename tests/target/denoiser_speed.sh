#!/usr/bin/env bash
# denoiser_speed.sh MACHINE ELF: what a sample costs the denoiser of the image's model, in instructions
# (QEMU counts one tick of the timer per instruction: exact, and the same on every computer), its RAM
# and its flash. Exits 1 where a figure is above its limit; limits are for sym8 x 5.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
machine=$1
elf=$(realpath "$2")
console=$(timeout --kill-after=1 120 qemu-system-arm -M "$machine" -display none -monitor none \
  -icount shift=0,sleep=off -semihosting-config enable=on,target=native \
  -serial null -serial null -serial stdio -kernel "$elf" </dev/null | tr -d '\r')
echo "$console"

# Flash: all functions that come from core/denoise, by the debug information.
flash=0
while read -r _ size _; do
  flash=$((flash + 0x$size))
done < <(arm-none-eabi-nm -S -l "$elf" | grep -i ' [tw] .*/core/denoise/' | sort -u -k1,1)
echo "denoiser flash: $flash"

# within RULE MEAN WORST RAM: the first sample, which primes the lines, may be no worse than any.
within() {
  local rule=$1 most_mean=$2 most_worst=$3 most_ram=$4 line
  line=$(grep "^denoiser $rule:" <<<"$console")
  [[ $line =~ mean\ ([0-9]+)\ worst\ ([0-9]+)\ first\ ([0-9]+)\ RAM\ ([0-9]+) ]]
  ((BASH_REMATCH[1] <= most_mean && BASH_REMATCH[2] <= most_worst && BASH_REMATCH[3] <= most_worst &&
    BASH_REMATCH[4] <= most_ram)) ||
    fail "above $most_mean mean, $most_worst worst or $most_ram bytes: $line"
}
within fixed 196 900 3072
within sqtwolog 230 1021 3072
within heursure 265 1180 3072
most_flash=2048
((0 < flash && flash <= most_flash)) || fail "flash is not within $most_flash bytes"
