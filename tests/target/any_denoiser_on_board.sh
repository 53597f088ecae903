#!/usr/bin/env bash
# any_denoiser_on_board.sh IMAGES FOGCOMP DIR: images whose header asks for other denoisers than sym8 x 5 (short and
# long filters, one level and many, each rule, soft and hard, none at all) send what this computer predicts.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
images=$1 fogcomp=$2 folder=$3
mkdir -p "$folder"
printf 'start 20 degC\nsoak 30 min\nramp to 50 degC at 1 degC/min\nsoak 30 min\n' >"$folder/warmer.profile"
"$fogcomp" simulate -o "$folder/run.csv" --rate 2 --profile "$folder/warmer.profile"

while read -r wavelet levels rule mode; do
  "$fogcomp" fit "$folder/run.csv" -o "$folder/gyro.model" --effects bias --wavelet "$wavelet" \
    --levels "$levels" --threshold "$rule" --mode "$mode" >/dev/null
  "$fogcomp" export "$folder/gyro.model" -o "$folder/fog_model.h" --output both --sample-rate 2 >/dev/null
  "$fogcomp" stream "$folder/fog_model.h" "$folder/run.csv" -o "$folder/in.bin" >/dev/null
  "$(dirname "$0")/header_matches_pc.sh" "$images" "$fogcomp" "$folder/fog_model.h" "$folder" stm32f405 "$folder/in.bin"
  echo "  with $wavelet x $levels, $rule, $mode"
done <<'SHAPES'
haar 1 fixed hard
db4 3 sqtwolog soft
coif5 6 heursure hard
db2 10 heursure soft
sym8 0 fixed soft
SHAPES
