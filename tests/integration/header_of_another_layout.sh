#!/usr/bin/env bash
# header_of_another_layout.sh FOGCOMP SOURCE IMAGES HEADER: a header that does not match the firmware is refused,
# by the compiler and by fogcomp, in words that say what to do.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "$1") source=$2 images=$3 header=$(realpath "$4")
enter_scratch

# As another version would have written it: its layout number in the macro and in the table.
sed -E 's/(FOG_MODEL_LAYOUT) [0-9]+/\1 99/; s/^  1179600717, [0-9]+,/  1179600717, 99,/' "$header" \
  >"$scratch/fog_model.h"
! cmp -s "$header" "$scratch/fog_model.h" || fail "nothing was changed"

printf 'time_s,temperature_degc,rate_dph\n0,20,1\n' >"$scratch/run.csv"
status=0
"$fogcomp" replay "$scratch/fog_model.h" "$scratch/run.csv" -o "$scratch/out.bin" 2>"$scratch/error" || status=$?
((status == 2)) || fail "replay: exit code $status: $(cat error)"
says error "another layout; export the header again"

if "$source/tests/target/build_variant.sh" "$images" stm32f405 fogcomp "$scratch/fogcomp.elf" \
  -DFOG_MODEL_HEADER="$scratch/fog_model.h" >log; then
  fail "the firmware was built with a header of another layout"
fi
says log "fog_model.h is for another version of the firmware: run fogcomp export again"
