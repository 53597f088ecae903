#!/usr/bin/env bash
# effect_sizes.sh [FOGCOMP MAKE_MODEL]: what each effect costs on the STM32F405: bytes of flash of the product
# image and instructions per block (of a second) in the drift model that it adds to an image with `bias` alone,
# and what networks of 10 neurons and some expressions add; "itself" is a network without its signals, lags and
# their scaling: inputs given, output ready. Of effects that follow the input rate it is what their coefficients take;
# what they cost a sample says tests/target/scale_factor_cost.sh. Then the same for all effects and a 3-10-1 network.
# Instructions are counted by QEMU's -icount with TIM2, one tick each; they are not cycles. Prints a table of Markdown.
set -euo pipefail
source=$(realpath "$(dirname "$0")/../..")
fogcomp=${1:-$source/build/host/fogcomp} make_model=${2:-$source/build/host/tests/target/make_model}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

# measure INPUTS [EFFECT...]: "flash mean max" of the images with a network of so many inputs and these effects,
# and "mean max" of the network itself if there is one.
measure() {
  "$make_model" one.model "$@"
  "$fogcomp" export one.model -o fog_model.h --extension --allow-error >/dev/null
  { cmake -S "$source" -B image --preset stm32f405 -DFOG_MODEL_HEADER="$scratch/fog_model.h"
    cmake --build image --target fogcomp block_cost; } >build.log 2>&1 || { cat build.log >&2; exit 1; }
  local flash ticks
  flash=$(arm-none-eabi-size -A image/fogcomp.elf |
    awk '$1 == ".text" || $1 == ".data" { sum += $2 } END { print sum }')
  ticks=$(timeout 60 qemu-system-arm -M netduinoplus2 -display none -monitor none -icount shift=0,sleep=off \
    -semihosting-config enable=on,target=native -serial null -serial null -serial stdio \
    -kernel image/block_cost.elf </dev/null | awk '/^(block|network):/ { printf "%s %s ", $3, $5 }')
  [[ $ticks ]] || { echo "no count from block_cost.elf" >&2; exit 1; }
  echo "$flash $ticks"
}

row() { printf '| %-26s | %6s | %6s | %6s |\n' "$@"; }
row effect "flash" "mean" "max"
echo "|---|---|---|---|"
read -r base_flash base_mean base_max < <(measure 0 bias)
row "thermal state and bias" "$base_flash" "$base_mean" "$base_max"
for effect in $("$fogcomp" effects | awk '/^[a-z_]+ - / { print $1 }'); do
  [[ $effect == bias ]] && continue
  "$fogcomp" effects "$effect" | grep '^  host only' >/dev/null && continue
  read -r flash mean max < <(measure 0 bias "$effect")
  row "$effect" "+$((flash - base_flash))" "$((mean - base_mean))" "$((max - base_max))"
done
for inputs in 2 3 4; do
  read -r flash mean max its_mean its_max < <(measure "$inputs" bias)
  row "network $inputs-10-1" "+$((flash - base_flash))" "$((mean - base_mean))" "$((max - base_max))"
  row "network $inputs-10-1 itself" "" "$its_mean" "$its_max"
done
for expression in 'x=T*T*dTdt' 'x=lag(T,300)-T' 'x=play(T,6)' 'x=exp(-t/1200)' 'x=sin(T/3)' 'x=tanh(T/20)' \
  'x=dTdt/(300+T)'; do
  read -r flash mean max < <(measure 0 bias "$expression")
  row "expression ${expression#x=}" "+$((flash - base_flash))" "$((mean - base_mean))" "$((max - base_max))"
done
read -r flash mean max _ < <(measure 3)
row "all and a 3-10-1 network" "$flash" "$mean" "$max"
