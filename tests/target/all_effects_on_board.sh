#!/usr/bin/env bash
# all_effects_on_board.sh IMAGES FOGCOMP MAKE_MODEL DIR: images with every effect that a board can have,
# expressions of every operation and a network of four inputs, boot on both machines and send for a recording with
# all inputs what this computer predicts: the sensor stream with its extension records, once as it is and once damaged.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
images=$1 fogcomp=$2 make_model=$3 folder=$4
mkdir -p "$folder"

"$make_model" "$folder/all.model" 4 all 'burst=T*T*dTdt' 'late=lag(T,300)-play(T,?r[2,9])' \
  'start=exp(-t/1200)*sin(T2/9)' \
  'supply=min(max(P/(1+abs(B)),1),W)^2/V-tanh(-T)'
"$fogcomp" export "$folder/all.model" -o "$folder/fog_model.h" --extension --output both --sample-rate 2 --allow-error
"$fogcomp" simulate -o "$folder/run.csv" --rate 2 --columns all --latitude 34
"$fogcomp" stream "$folder/fog_model.h" "$folder/run.csv" -o "$folder/good.bin"
# Records, samples and their sync bytes are all hit.
head -c 400000 "$folder/good.bin" >"$folder/damaged.bin"
for at in $(seq 1000 4099 399999); do
  printf '\xA5' | dd of="$folder/damaged.bin" bs=1 seek="$at" conv=notrunc status=none
done

"$(dirname "$0")/header_matches_pc.sh" "$images" "$fogcomp" "$folder/fog_model.h" "$folder" "stm32f405 mps2_an386" \
  "$folder/good.bin" "$folder/damaged.bin"
