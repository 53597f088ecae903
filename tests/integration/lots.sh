#!/usr/bin/env bash
# lots.sh FOGCOMP: of a lot with a noisy gyro, one with an effect that the model lacks, one whose coefficient is off and
# one whose bias differs from run to run, batch names each by what makes it one, says why a gyro fails, and nobody else.
# Of the gyro that fails it says what `diagnose` says: how often that is the hidden effect is the benchmark's question.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: lots.sh FOGCOMP}")
enter_scratch

# simulate FILE SEED OPTIONS...: a gyro with the coefficient of its folder.
simulate() {
  local file=$1 seed=$2
  shift 2
  mkdir -p "$(dirname "$file")"
  "$fogcomp" simulate -o "$file" --seed "$seed" "$@" >said.txt
}
coefficient() {
  random_awk -v seed="$1" 'BEGIN { seed_draws(seed)
    printf "temperature_rate:coefficient=%.4f", 0.137 + 0.04 * (uniform() - 0.5) }'
}
for number in $(seq 1 12); do
  options=(--effect "$(coefficient "$number")")
  ((number == 3)) && options+=(--effect thermal_hysteresis:width_dph=0.1)
  ((number == 7)) && options+=(--noise white=0.0025)
  ((number == 9)) && options=(--effect temperature_rate:coefficient=0.9)
  simulate "gyros/$(printf 'G%02d' "$number")/run.csv" "$number" "${options[@]}"
done
simulate gyros/G03/holdout.csv 103 --profile reversed --effect "$(coefficient 3)" \
  --effect thermal_hysteresis:width_dph=0.1
simulate gyros/G05/holdout.csv 105 --profile reversed --effect "$(coefficient 5)" --effect bias:value_dph=0.854

options=(--effects bias,bias_temperature,temperature_rate,temperature_rate_product,warm_up,polarization_ripple --jobs 2)
echo "fit_drift_dph <= 0.015" >limits.txt
status=0
"$fogcomp" batch gyros -o out "${options[@]}" --limits limits.txt >said.txt 2>errors.txt || status=$?
((status == 1)) || fail "exit code $status: $(cat said.txt errors.txt)"
says said.txt '^12 gyros: 11 pass, 1 fail, 0 without a result'
says said.txt '^  G03 +fail +fit_drift_dph 0\.[0-9]+, must be <= 0\.015 +'
says said.txt '^  G05 +turn-on bias: holdout.csv is 0\.1[12][0-9]+ \+- 0\.00[0-9]+ deg/h above run\.csv$'
says said.txt '^  G07 +(noise_dprh|fit_floor_dph) 0\.0[0-9]+ \(lot 0\.0[0-9]+ \+- .*spreads above\)'
says said.txt '^  G09 +temperature_rate\.K 0\.(89|90).*spreads above\)'
named=$(sed -n '/^Unlike/,/^[0-9]* calibrated/s/^  \(G[0-9]*\) .*/\1/p' said.txt | sort | tr '\n' ' ')
[[ $named == "G03 G07 G09 " || $named == "G03 G05 G07 G09 " ]] || fail "named: $named; $(cat said.txt)"

# The same in the table and for scripts.
cell() { python3 -c 'import csv, sys
for row in csv.DictReader(open("out/gyros.csv")):
    if row["gyro"] == sys.argv[1]: print(row[sys.argv[2]])' "$@"; }
[[ $(cell G05 why) == "turn-on bias: "* && -z $(cell G01 why)$(cell G01 stands_out) ]] || fail "$(cat out/gyros.csv)"
[[ $(cell G07 stands_out) == *noise_dprh* ]] || fail "stands_out: $(cell G07 stands_out)"
before=$(stat -c %Y.%i out/G03/diagnosis.txt)
"$fogcomp" batch gyros -o out "${options[@]}" --limits limits.txt --json >batch.json 2>errors.txt || true
[[ $(stat -c %Y.%i out/G03/diagnosis.txt) == "$before" ]] || fail "diagnosed again"
holds batch.json '.gyros[0].gyro == "G01" and .gyros[0].diagnosis == null and .gyros[0].outliers == []'
holds batch.json '.gyros[4].notes[0] | startswith("turn-on bias")'
holds batch.json '[.gyros[6].outliers[].figure] | index("noise_dprh")'
holds batch.json '.lot.bound > 10 and (.lot.figures | length) > 10'

# What is wrong with the third is what `diagnose` says of it.
"$fogcomp" diagnose out/G03/G03.model gyros/G03/run.csv --holdout gyros/G03/holdout.csv --json >diagnose.json
holds batch.json ".gyros[2].diagnosis.verdict == \"$(value diagnose.json .verdict)\""
holds batch.json '.gyros[2].diagnosis.verdict != "none" and (.gyros[2].diagnosis.size_dph | 0.01 < . and . < 0.05)'
if [[ $(value diagnose.json .verdict) == missing_effect ]]; then
  holds batch.json ".gyros[2].diagnosis.effects == $(value diagnose.json .effects)"
  [[ $(cell G03 why) == "$(value diagnose.json .effect) is missing: "* ]] || fail "why: $(cell G03 why)"
fi
"$fogcomp" diagnose out/G03/G03.model gyros/G03/run.csv --holdout gyros/G03/holdout.csv >diagnose.txt
grep -qxF -- "$(grep '^  next: ' diagnose.txt)" said.txt || fail "$(cat said.txt) proposes not what diagnose does: $(cat diagnose.txt)"

# fit and compare say the same of the two runs.
runs=(gyros/G05/run.csv gyros/G05/holdout.csv)
"$fogcomp" compare out/G05/G05.model "${runs[@]}" >said.txt
says said.txt '^  turn-on bias: holdout.csv is 0\.1[12][0-9]+ \+- 0\.00[0-9]+ deg/h above run\.csv$'
"$fogcomp" fit "${runs[@]}" -o both.model "${options[@]:0:2}" >said.txt
says said.txt '^  turn-on bias: holdout.csv is 0\.1[12][0-9]+ '
says said.txt 'each power-on has a bias of its own here \(one sigma 0\.0[0-9]+ deg/h\), so that .*; a board has their mean$'
"$fogcomp" fit "${runs[@]}" -o each.model "${options[@]:0:2}" --run-offsets --json >fit.json
holds fit.json '.turn_on_bias[0].certain and 4 * .turn_on_bias[0].sigma_dph < 0.03'
holds fit.json '(.turn_on_bias[0].above_dph - 0.12 | fabs) < 4 * .turn_on_bias[0].sigma_dph'
cmp both.model each.model || fail "biases that certainly differ are not fitted as with --run-offsets"
echo "a lot names its odd ones, and why"
