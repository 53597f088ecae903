#!/usr/bin/env bash
# all_effects_on_board.sh FOGCOMP MAKE_MODEL SOURCE DIR: images with every effect that a board can have,
# expressions of every operation and a network of four inputs, boot on both machines and send for a recording with all inputs what this computer predicts: the
# sensor stream with its extension records, once as it is and once damaged.
set -euo pipefail
fogcomp=$1 make_model=$2 source=$3 folder=$4
mkdir -p "$folder"

"$make_model" "$folder/all.model" 4 all 'burst=T*T*dTdt' 'late=lag(T,300)-play(T,?r[2,9])' 'start=exp(-t/1200)*sin(T2/9)' \
  'supply=min(max(P/(1+abs(B)),1),W)^2/V-tanh(-T)'
"$fogcomp" export "$folder/all.model" -o "$folder/fog_model.h" --extension --output both --sample-rate 2
"$fogcomp" simulate -o "$folder/run.csv" --rate 2 --columns all --latitude 34
"$fogcomp" stream "$folder/fog_model.h" "$folder/run.csv" -o "$folder/good.bin"
# Records, samples and their sync bytes are all hit.
head -c 400000 "$folder/good.bin" >"$folder/damaged.bin"
for at in $(seq 1000 4099 399999); do
  printf '\xA5' | dd of="$folder/damaged.bin" bs=1 seek="$at" conv=notrunc status=none
done

for board in stm32f405:netduinoplus2 mps2_an386:mps2-an386; do
  build=$folder/${board%:*}
  cmake -S "$source" -B "$build" --preset "${board%:*}" \
    -DFOG_MODEL_HEADER="$folder/fog_model.h" >"$folder/build.log"
  cmake --build "$build" --target fogcomp_bulk >>"$folder/build.log" || { cat "$folder/build.log"; exit 1; }
  for stream in good damaged; do
    "$fogcomp" replay "$folder/fog_model.h" "$folder/$stream.bin" -o "$folder/expected.bin"
    ln -sf "$folder/$stream.bin" "$build/in.bin"
    rm -f "$build/out.bin"
    "$source/tests/target/run_semihosted.sh" "${board#*:}" "$build/fogcomp_bulk.elf" "$build"
    cmp "$folder/expected.bin" "$build/out.bin"
    echo "${board%:*}, $stream stream: $(stat -c %s "$build/out.bin") bytes compared, 0 differ"
  done
done
