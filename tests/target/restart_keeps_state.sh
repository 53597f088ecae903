#!/usr/bin/env bash
# restart_keeps_state.sh PROGRAM MACHINE PLATFORM IMAGES FOGCOMP MAKE_MODEL DIR: a board with slow lags that its
# self-test restarts in the middle of a recording goes on as if nothing had happened, but for the samples that it did
# not see.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
program=$1 machine=$2 platform=$3 images=$4 fogcomp=$5 make_model=$6 folder=$7
here=$(realpath "$(dirname "$0")")
mkdir -p "$folder"
# No warm-up: it is not trusted before five time constants (drift_under_faults_test has one).
"$make_model" "$folder/slow.model" 0 bias temperature_rate shupe 'late=lag(T,200)-T'
"$fogcomp" export "$folder/slow.model" -o "$folder/slow.h" --sample-rate 2 --output compact --invalid none \
  --allow-error >/dev/null
"$here/build_variant.sh" "$images" "$platform" fogcomp "$folder/fogcomp.elf" \
  -DFOG_MODEL_HEADER="$(realpath "$folder/slow.h")"
"$fogcomp" simulate -o "$folder/run.csv" --rate 2 --seed 3
"$fogcomp" stream "$folder/slow.h" "$folder/run.csv" -o "$folder/whole.bin"
head -c 80000 "$folder/whole.bin" >"$folder/in.bin"
"$fogcomp" replay "$folder/slow.h" "$folder/in.bin" -o "$folder/expected.bin"
# The second word of the model in RAM: the CRC of its file, which no drift depends on.
model=$(arm-none-eabi-nm -C "$folder/fogcomp.elf" | awk '$3 == "fog::app::model()::instance" { print $1 }')
"$program" "$machine" "$folder/fogcomp.elf" "$folder/in.bin" "$folder/expected.bin" "$(printf %x $((0x$model + 4)))"
