#!/usr/bin/env bash
# denoiser_speed.sh MACHINE ELF: what a sample costs the denoiser of the image's model, in instructions
# (QEMU counts one tick of the timer per instruction: exact, and the same on every computer), and its
# RAM. Exits 1 where a figure is above its limit; limits are for sym8 x 5.
set -euo pipefail
machine=$1
elf=$(realpath "$2")
console=$(timeout --kill-after=1 120 qemu-system-arm -M "$machine" -display none -monitor none \
  -icount shift=0,sleep=off -semihosting-config enable=on,target=native \
  -serial null -serial null -serial stdio -kernel "$elf" </dev/null | tr -d '\r')
echo "$console"

# within RULE MEAN WORST RAM
within() {
  local rule=$1 most_mean=$2 most_worst=$3 most_ram=$4 line
  line=$(grep "^denoiser $rule:" <<<"$console")
  [[ $line =~ mean\ ([0-9]+)\ worst\ ([0-9]+)\ first\ [0-9]+\ RAM\ ([0-9]+) ]]
  ((BASH_REMATCH[1] <= most_mean && BASH_REMATCH[2] <= most_worst && BASH_REMATCH[3] <= most_ram)) ||
    { echo "above $most_mean mean, $most_worst worst or $most_ram bytes: $line" >&2; exit 1; }
}
within fixed 280 1140 3072
within sqtwolog 322 1304 3072
within heursure 358 1484 3072
