#!/usr/bin/env bash
# any_denoiser_on_board.sh FOGCOMP SOURCE DIR: images whose header asks for other denoisers than sym8 x 5 (short and
# long filters, one level and many, each rule, soft and hard, none at all) send what this computer predicts.
set -euo pipefail
fogcomp=$1 source=$2 folder=$3
mkdir -p "$folder"
"$fogcomp" simulate -o "$folder/run.csv" --rate 2

while read -r wavelet levels rule mode; do
  "$fogcomp" fit "$folder/run.csv" -o "$folder/gyro.model" --effects bias --wavelet "$wavelet" \
    --levels "$levels" --threshold "$rule" --mode "$mode" >/dev/null
  "$fogcomp" export "$folder/gyro.model" -o "$folder/fog_model.h" --output both --sample-rate 2 >/dev/null
  "$fogcomp" stream "$folder/fog_model.h" "$folder/run.csv" -o "$folder/in.bin" >/dev/null
  "$fogcomp" replay "$folder/fog_model.h" "$folder/in.bin" -o "$folder/expected.bin" >/dev/null
  cmake -S "$source" -B "$folder/build" --preset stm32f405 -DFOG_MODEL_HEADER="$folder/fog_model.h" \
    >"$folder/build.log"
  cmake --build "$folder/build" --target fogcomp_bulk >>"$folder/build.log" ||
    { cat "$folder/build.log"; exit 1; }
  ln -sf "$folder/in.bin" "$folder/build/in.bin"
  rm -f "$folder/build/out.bin"
  "$source/tests/target/run_semihosted.sh" netduinoplus2 "$folder/build/fogcomp_bulk.elf" "$folder/build" >/dev/null
  cmp "$folder/expected.bin" "$folder/build/out.bin"
  echo "$wavelet x $levels, $rule, $mode: $(stat -c %s "$folder/build/out.bin") bytes compared, 0 differ"
done <<'SHAPES'
haar 1 fixed hard
db4 3 sqtwolog soft
coif5 6 heursure hard
db2 10 heursure soft
sym8 0 fixed soft
SHAPES
