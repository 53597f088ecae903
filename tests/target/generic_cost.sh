#!/usr/bin/env bash
# generic_cost.sh IMAGES FOGCOMP MAKE_MODEL DIR IN.bin: what an image built for one gyro and the generic one take for
# the same models: flash, RAM, instructions of 16 bytes of the sensor stream; IN.bin for a small model, a recording
# with all inputs for one with all effects, a network and expressions.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
images=$1 fogcomp=$2 make_model=$3 folder=$4 input=$5
here=$(realpath "$(dirname "$0")")
mkdir -p "$folder"
"$make_model" "$folder/small.model" 2 bias bias_temperature temperature_rate
"$make_model" "$folder/all.model" 4 all 'burst=T*T*dTdt' 'late=lag(T,300)-play(T,?r[2,9])' \
  'start=exp(-t/1200)*sin(T2/9)'
generic=$images/generic/stm32f405

# cost NAME ELF
cost() {
  local flash ram sizes
  sizes=$(arm-none-eabi-size -A "$2")
  flash=$(awk '/^\.(text|data|seal) / { sum += $2 } END { print sum }' <<<"$sizes")
  ram=$(awk '/^\.(data|bss|noinit|dma_buffers|stack) / { sum += $2 } END { print sum }' <<<"$sizes")
  echo "$1: flash $flash, RAM $ram bytes"
}
printf 'start 20 degC\nsoak 5 min\n' >"$folder/rest.profile"
head -c 640000 "$input" >"$folder/small_inputs.bin"
input=$folder/small_inputs.bin
"$fogcomp" simulate -o "$folder/run.csv" --profile "$folder/rest.profile" --preset paper --rate 200 --columns all \
  --latitude 34 >/dev/null
for model in small all; do
  options=(--extension --allow-error)
  "$fogcomp" export "$folder/$model.model" -o "$folder/$model.h" "${options[@]}" >/dev/null
  "$fogcomp" export "$folder/$model.model" --format table -o "$folder/$model.bin" "${options[@]}" >/dev/null
  for target in fogcomp sample_cost; do
    "$here/build_variant.sh" "$images" stm32f405 "$target" "$folder/$model.$target.elf" \
      -DFOG_MODEL_HEADER="$(realpath "$folder/$model.h")"
  done
  if [[ $model == all ]]; then
    "$fogcomp" stream "$folder/all.h" "$folder/run.csv" -o "$folder/whole.bin" >/dev/null
    head -c 1000000 "$folder/whole.bin" >"$folder/all_inputs.bin"
    input=$folder/all_inputs.bin
  fi
  cost "$model, image of its own" "$folder/$model.fogcomp.elf"
  "$here/sample_cost.sh" "$folder/$model.sample_cost.elf" "$folder" 13500 "$input"
  cost "$model, generic image" "$generic/fogcomp.elf"
  FOG_TABLE="0x0800C000=$folder/$model.bin" "$here/sample_cost.sh" "$generic/sample_cost.elf" "$folder" 13500 "$input"
done
