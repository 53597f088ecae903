#!/usr/bin/env bash
# scale_factor_cost.sh IMAGES FOGCOMP MAKE_MODEL DIR: what the effects that follow the input rate cost a sample at
# any rate, in instructions: each by itself 60 at most, all together 90. QEMU counts one tick of the timer per
# instruction; they are not cycles.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
images=$1 fogcomp=$2 make_model=$3 folder=$4
here=$(realpath "$(dirname "$0")")
mkdir -p "$folder"

# expect_cost MOST EFFECT...
expect_cost() {
  local max=$1 console
  shift
  "$make_model" "$folder/one.model" 0 bias "$@"
  "$fogcomp" export "$folder/one.model" -o "$folder/fog_model.h" >/dev/null
  "$here/build_variant.sh" "$images" stm32f405 block_cost "$folder/block_cost.elf" \
    -DFOG_MODEL_HEADER="$(realpath "$folder/fog_model.h")"
  console=$(timeout --kill-after=1 60 qemu-system-arm -M netduinoplus2 -display none -monitor none \
    -icount shift=0,sleep=off \
    -semihosting-config enable=on,target=native -serial null -serial null -serial stdio \
      -kernel "$folder/block_cost.elf" </dev/null)
  [[ $console =~ sample:\ mean\ ([0-9]+)\ max\ ([0-9]+) ]]
  echo "$*: mean ${BASH_REMATCH[1]}, max ${BASH_REMATCH[2]} of $max instructions a sample"
  ((BASH_REMATCH[2] <= max))
}
expect_cost 0
expect_cost 60 scale_factor
expect_cost 60 scale_factor_temperature
expect_cost 60 scale_factor_nonlinearity
expect_cost 60 scale_factor_asymmetry
expect_cost 90 scale_factor{,_temperature,_nonlinearity,_asymmetry}
