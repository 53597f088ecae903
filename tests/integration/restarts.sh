#!/usr/bin/env bash
# restarts.sh FOGCOMP: a gyro that is switched off and on while the recorder goes on. The recording says so in uptime_s;
# then a warm-up that was identified at one power-on is right after the others, and a run with restarts tells it from
# an ageing, as the proposed experiment promises.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: restarts.sh FOGCOMP}")
enter_scratch

gyro=(--preset none --rate 0.1 --noise white=0.0015 --effect bias --effect temperature_rate
      --effect warm_up:amplitude_dph=0.3,tau_s=1500)
"$fogcomp" simulate -o steps.csv --profile random_steps --seed 3 "${gyro[@]}" >/dev/null
"$fogcomp" simulate -o restarts.csv --profile power_cycles --seed 4 "${gyro[@]}" >/dev/null
[[ $(head -n 1 restarts.csv) == time_s,temperature_degc,rate_dph,uptime_s ]] || fail "columns: $(head -n 1 restarts.csv)"
[[ $(head -n 1 steps.csv) == time_s,temperature_degc,rate_dph ]] || fail "columns: $(head -n 1 steps.csv)"
"$fogcomp" info restarts.csv >said.txt
says said.txt '5640 samples at 0.1 Hz, 17.67 h, 3 gaps, 3 restarts'
cut -d, -f1-3 restarts.csv >untold.csv
"$fogcomp" fit steps.csv -o gyro.model --effects bias,temperature_rate,warm_up >/dev/null

# left RUN: what the model leaves of it, in units of its noise floor.
left() {
  "$fogcomp" compare gyro.model "$1" --json | jq '.runs[0] | .residual_rms_dph / .noise_floor_dph'
}
told=$(left restarts.csv) untold=$(left untold.csv)
echo "left: $told of the noise, $untold if nobody says that the power was off"
awk -v told="$told" -v untold="$untold" 'BEGIN { exit !(told < 1.1 && untold > 1.3) }' ||
  fail "$told of the noise is left, and $untold of a recording that does not say that the power was off"

"$fogcomp" fit restarts.csv -o declared.model --effects bias,temperature_rate >/dev/null
"$fogcomp" diagnose declared.model restarts.csv >said.txt
says said.txt '^missing effect: warm_up '

"$fogcomp" convert restarts.csv -o again.csv 2>/dev/null
cmp restarts.csv again.csv
"$fogcomp" replay gyro.model restarts.csv -o board.bin >said.txt 2>&1
says said.txt 'restarts.csv: was switched on again at [0-9]* s; the board sees it as if it had stayed on'

# A gyro of another bias at every power-on: one bias for all refuses the warm-up, which has one of its own for each.
awk -F, -v OFS=, 'NR > 1 { if ($4 + 0 < up) ++on; up = $4 + 0; $3 += 0.35 * sin(2.1 * on) } { print }' restarts.csv >turn_on.csv
"$fogcomp" fit turn_on.csv -o turn_on.model --effects bias,temperature_rate >/dev/null
"$fogcomp" diagnose turn_on.model turn_on.csv --details >said.txt || true
says said.txt '^missing effect: warm_up '
says said.txt --run-offsets
eval "\"\$fogcomp\" $(sed -n 's/^  next: fogcomp //p' said.txt)" >added.txt || fail "refused: $(cat added.txt)"
"$fogcomp" diagnose NEW.model turn_on.csv --details >said.txt
says said.txt '^nothing is missing'
says said.txt 'the bias of turn_on.csv from [0-9]* s on is '
echo "restarts are seen, and told"
