#!/usr/bin/env bash
# first_heat.sh FOGCOMP: a gyro whose bias moves for good whenever its coil gets warmer than ever before. The loop calls
# it what it looks like, says which physics gives it and how to tell, and takes it out of another programme, too; the
# board has it as a part of its bias.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: first_heat.sh FOGCOMP}")
enter_scratch

for profile in reversed ramp_rates; do
  "$fogcomp" simulate -o "$profile.csv" --profile "$profile" --seed 71 --preset none --rate 0.1 \
    --noise white=0.0014,flicker=0.0007 --effect bias --effect bias_temperature --effect temperature_rate \
    --effect warmest_so_far:scale=4 >/dev/null
done
"$fogcomp" fit reversed.csv -o gyro.model --effects bias,bias_temperature:order=2,temperature_rate >/dev/null
"$fogcomp" diagnose gyro.model reversed.csv --details >said.txt
cat said.txt
says said.txt 'outside the catalogue it looks like highest\(T\)'
says said.txt "which physics gives such a form: a coil's first heat"
says said.txt 'the same programme once more would tell'
eval "\"\$fogcomp\" $(sed -n 's/^  next: fogcomp //p' said.txt)" >added.txt || fail "refused: $(cat added.txt)"

left() { "$fogcomp" compare "$1" ramp_rates.csv --json >compare.json && value compare.json '.runs[0].residual_rms_dph'; }
before=$(left gyro.model) after=$(left NEW.model)
echo "another programme: $before -> $after deg/h"
awk -v before="$before" -v after="$after" 'BEGIN { exit !(after < before / 2) }' ||
  fail "another programme: $before -> $after deg/h"

"$fogcomp" compare NEW.model ramp_rates.csv >compare.txt
says compare.txt 'warning: T_highest begins anew here'

"$fogcomp" export NEW.model -o fog_model.h --sample-rate 0.1 >export.txt
cat export.txt
says export.txt '^note: T_highest is taken at .* degC, the highest trained temperature'
