#!/usr/bin/env bash
# own_expression.sh FOGCOMP SOURCE IMAGES: a drift that no effect of the catalogue describes is fitted with an
# expression, its parameter found, saved, compared and exported within the bound that the header states; model and
# header replay to the same bytes, and the flash image of both boards sends them too (where QEMU and the compiler are).
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "$1") source=$2 images=$3
enter_scratch

# 0.1 deg/h of tanh((T - 5) / 8) beside what the ideal gyro has.
"$fogcomp" simulate -o plain.csv --preset none --noise white=0.001 --rate 0.1 >/dev/null
awk -F, -v OFS=, '/^[0-9]/ { x = ($2 - 5) / 8; $3 += 0.5 + 0.1 * (exp(x) - exp(-x)) / (exp(x) + exp(-x)) } { print }' \
  plain.csv >run.csv
"$fogcomp" fit run.csv -o gyro.model --effects bias --effect-expr 'kink = tanh((T - ?at[-30,50]) / ?w[2,30])' >fit.txt
values=$(sed -nE 's/.*, at ([-0-9.]+) .*, w ([0-9.]+) .*/\1 \2/p' fit.txt)
size=$(awk '$1 == "k" { print $3 }' fit.txt)
echo "at, w: $values; k: $size"
awk -v values="$values" -v size="$size" 'BEGIN {
  split(values, v, " ")
  exit !(v[1] > 4.5 && v[1] < 5.5 && v[2] > 7.5 && v[2] < 8.5 && size > 0.098 && size < 0.102)
}' || fail "at, w: $values, not 5 and 8; k: $size, not 0.1"
"$fogcomp" compare gyro.model run.csv --json >compare.json
holds compare.json '0 < .runs[0].residual_rms_dph and .runs[0].residual_rms_dph < 0.05'

"$fogcomp" export gyro.model -o fog_model.h --sample-rate 0.1 --output both >export.txt
cat export.txt
awk '/^  kink: at most/ { found = 1; exit !($4 <= $9) } END { exit !found }' export.txt
grep -q '/\* kink: (tanh((T - ?at\[-30,50\]) / ?w\[2,30\])) / 2^-1, within .* of it in double' fog_model.h
"$fogcomp" replay gyro.model run.csv -o model.bin --sample-rate 0.1 --output both
"$fogcomp" replay fog_model.h run.csv -o header.bin
cmp model.bin header.bin

# Inputs that come in extension records, in an expression and in a network.
"$fogcomp" simulate -o field.csv --profile field_and_vibration --columns supply,vibration --effect vibration >/dev/null
"$fogcomp" fit field.csv -o shaken.model --effects bias --effect-expr 'shaken = g^2' --network 3 \
  --inputs supply,vibration --force-network >/dev/null
"$fogcomp" export shaken.model -o shaken.h --sample-rate 0.1 --extension >shaken.txt
awk '/^  shaken: at most/ { found = 1; exit !($4 <= $9) } END { exit !found }' shaken.txt
"$fogcomp" replay shaken.model field.csv -o shaken_model.bin --sample-rate 0.1 --extension
"$fogcomp" replay shaken.h field.csv -o shaken_header.bin
cmp shaken_model.bin shaken_header.bin

if ! command -v qemu-system-arm >/dev/null || ! command -v arm-none-eabi-g++ >/dev/null; then
  echo "skipped: the boards, no QEMU or no compiler here"
  exit 77
fi
"$fogcomp" stream fog_model.h run.csv -o in.bin
"$source/tests/target/header_matches_pc.sh" "$images" "$fogcomp" fog_model.h . "stm32f405 mps2_an386" in.bin
cmp header.bin expected_in.bin
