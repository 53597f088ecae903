#!/usr/bin/env bash
# header_of_another_layout.sh FOGCOMP SOURCE IMAGES HEADER: a header that does not match the firmware is refused,
# by the compiler and by fogcomp, in words that say what to do.
set -euo pipefail
fogcomp=$1 source=$2 images=$3 header=$4
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# As another version would have written it: its layout number in the macro and in the table.
sed -E 's/(FOG_MODEL_LAYOUT) [0-9]+/\1 99/; s/^  1179600717, [0-9]+,/  1179600717, 99,/' "$header" \
  >"$scratch/fog_model.h"
cmp -s "$header" "$scratch/fog_model.h" && { echo "nothing was changed" >&2; exit 1; }

printf 'time_s,temperature_degc,rate_dph\n0,20,1\n' >"$scratch/run.csv"
status=0
"$fogcomp" replay "$scratch/fog_model.h" "$scratch/run.csv" -o "$scratch/out.bin" 2>"$scratch/error" || status=$?
cat "$scratch/error"
((status == 2)) || { echo "exit code $status" >&2; exit 1; }
grep -q "another layout version; export the header again" "$scratch/error"

if "$source/tests/target/build_variant.sh" "$images" stm32f405 fogcomp "$scratch/fogcomp.elf" \
  -DFOG_MODEL_HEADER="$scratch/fog_model.h" >"$scratch/log"; then
  echo "the firmware was built with a header of another layout" >&2
  exit 1
fi
grep -o "fog_model.h is for another version of the firmware: run fogcomp export again" "$scratch/log" | head -n 1
