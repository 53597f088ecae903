#!/usr/bin/env bash
# error_ladder.sh FOGCOMP: a model is improved step by step as an engineer would: compare says what is
# left and on what it depends, add keeps what helps out of sample and refuses what does not, history shows it.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: error_ladder.sh FOGCOMP}")
enter_scratch

for seed in 1 2; do "$fogcomp" simulate -o "run$seed.csv" --seed "$seed" >/dev/null; done
"$fogcomp" fit run1.csv -o static.model --effects bias,bias_temperature >/dev/null

# The rate term is missing: the residual depends on rate and history; with it, far less is left.
"$fogcomp" compare static.model run1.csv --json >static.json
holds static.json '.runs[0].structure.temperature_rate.structured and .runs[0].structure.history.structured'
"$fogcomp" compare static.model run1.csv >static.txt
says static.txt 'of what is above the floor: .*temperature rate'

"$fogcomp" add static.model temperature_rate run1.csv --holdout run2.csv -o rate.model --json >add.json
holds add.json '.accepted and (.runs[0].holdout | not) and .runs[1].holdout'
holds add.json '.runs[1].rms_after_dph < 0.7 * .runs[1].rms_before_dph'
# The same without a holdout: the same model, judged by cross-validation.
"$fogcomp" add static.model temperature_rate run1.csv -o again.model >again.txt || fail "$(cat again.txt)"
says again.txt '^accepted: helps out of sample.*left out'
cmp <(grep '^effect' rate.model) <(grep '^effect' again.model) || fail "the judge changed the model"

# An effect that this gyro does not have: refused, exit code 1, nothing written, unless forced.
for judge in "" "--holdout run2.csv"; do
  status=0
  # shellcheck disable=SC2086
  "$fogcomp" add rate.model thermal_hysteresis:radius=3 run1.csv -o useless.model $judge >refused.txt || status=$?
  ((status == 1)) || fail "exit code $status: $(cat refused.txt)"
  [[ ! -e useless.model ]] || fail "useless.model is written although refused"
  says refused.txt '^refused: does not help out of sample' "judged by '$judge'"
done
"$fogcomp" add rate.model thermal_hysteresis:radius=3 run1.csv -o forced.model --force >forced.txt
says forced.txt '^written by --force: forced.model'

# A network is trained anew, of the same size.
"$fogcomp" fit run1.csv -o network.model --effects bias,bias_temperature --network 4 >/dev/null
"$fogcomp" add network.model temperature_rate run1.csv -o network2.model >/dev/null
says network2.model '^hidden logsig 4 '

# A network to which the effects leave nothing is not kept, and that is said; forced, it is.
complete=bias,bias_temperature,temperature_rate,temperature_rate_product,warm_up,polarization_ripple:period2=?
"$fogcomp" fit run1.csv -o alone.model --effects "$complete" --network 4 >alone.txt
says alone.txt '^  network: nothing left that it can learn.*none kept; --force-network keeps it$'
! grep -q '^hidden' alone.model || fail "a network that does not help is kept: $(cat alone.txt)"
"$fogcomp" fit run1.csv -o kept.model --effects "$complete" --network 4 --force-network >/dev/null
says kept.model '^hidden logsig 4 ' --force-network

# The ladder.
"$fogcomp" history forced.model --json >history.json
holds history.json '.steps[0].action == "fit bias,bias_temperature" and .steps[1].action == "add temperature_rate"'
holds history.json '(.steps[1].forced | not) and .steps[2].forced'
holds history.json ".steps[1].holdout_rms_after_dph - $(value add.json '.runs[1].rms_after_dph') | fabs < 1e-9"
holds history.json '.steps[1].data_hash == .steps[0].data_hash'
holds history.json '.steps[1].excess_removed | 0.5 < . and . <= 1'
"$fogcomp" history forced.model >history.txt
says history.txt '####.*1 fit bias'
says history.txt 'forced: did not help'

# The loop's model is what the commands that it prints make, to the byte, on any number of cores.
one_core=$(taskset -cp $$ | sed 's/.*: *//; s/[,-].*//')
for start in "static.model" "static.model --holdout run2.csv" "network.model"; do
  read -r model judge <<<"$start"
  # shellcheck disable=SC2086
  "$fogcomp" diagnose "$model" run1.csv --max-effects 2 -o loop.model $judge >loop.txt || fail "$(cat loop.txt)"
  mv loop.model at_once.model
  sed -n 's/^ *fogcomp add /add /p' loop.txt | grep -v NEW >steps.txt
  # two effects; refinements of their formulas (NAME:parameter=?) come in addition
  [[ $(grep -vc '=?' steps.txt) == 2 ]] || fail "two steps expected: $(cat loop.txt)"
  [[ $(grep -c '=?' steps.txt) == "$(grep -c '(a refinement)' loop.txt)" ]] || fail "no refinement: $(cat loop.txt)"
  # More is missing than two steps add: what it proposes goes on with its model, and is accepted.
  going_on="diagnose loop.model run1.csv${judge:+ $judge}"
  grep -qx "  next: fogcomp $going_on" loop.txt || fail "$start: not to go on: $(cat loop.txt)"
  cp at_once.model loop.model
  # shellcheck disable=SC2086
  "$fogcomp" $going_on >/dev/null || fail "refused: $going_on"
  while read -r step; do
    eval "taskset -c $one_core \"\$fogcomp\" $step" >step.txt || fail "$(cat step.txt)" # words quoted for a shell
  done <steps.txt
  cmp loop.model at_once.model || fail "$start: another model than that of $(cat steps.txt)"
done
# On a holdout each step has the error that `history` prints.
"$fogcomp" diagnose static.model run1.csv --max-effects 2 -o loop.model --holdout run2.csv --json >loop.json
"$fogcomp" history loop.model --json >loop_history.json
errors='map([.holdout_rms_before_dph, .holdout_rms_after_dph])'
holds loop.json "(.ladder[0:2] | $errors) == $(value loop_history.json ".steps[1:3] | $errors")"
# With nothing to add there is no model to write.
status=0
"$fogcomp" diagnose at_once.model run1.csv --max-effects 1 -o none.model >none.txt || status=$?
[[ $status == 0 || ( $status == 1 && ! -e none.model ) ]] || fail "exit code $status: $(cat none.txt)"

# From a cubic polynomial the loop finds everything that these gyros have, and ends at their noise.
for seed in 1 2; do
  "$fogcomp" fit "run$seed.csv" -o cubic.model --effects bias,bias_temperature:order=3 >/dev/null
  "$fogcomp" diagnose cubic.model "run$seed.csv" --max-effects 6 -o whole.model >whole.txt
  says whole.txt '^  at the end: nothing is missing' "seed $seed"
  says whole.txt '^  next: fogcomp export whole.model -o fog_model.h$' "seed $seed"
  for effect in temperature_rate temperature_rate_product polarization_ripple warm_up; do
    grep -q "^effect $effect " whole.model || fail "seed $seed: $effect is not found: $(cat whole.txt)"
  done
  "$fogcomp" compare whole.model "run$seed.csv" --json >whole.json
  holds whole.json '.runs[0].residual_rms_dph < 1.03 * .runs[0].noise_floor_dph'
done

# What is proposed can be typed as it stands, whatever a file is called and however it was read.
awk 'NR == 9 { print "damaged,row,here" } { print }' run1.csv >"run of monday.csv"
proposed="fit 'run of monday.csv' -o \"monday's model\" --effects bias,bias_temperature --skip-bad-rows"
for _ in fit diagnose add diagnose; do
  eval "\"$fogcomp\" $proposed" >typed.txt || fail "$proposed: $(cat typed.txt)"
  proposed=$(sed -n 's/^  next: fogcomp //p' typed.txt)
  [[ $proposed == *"'run of monday.csv'"*--skip-bad-rows* ]] || fail "the next command is: $proposed"
done

# Two models and two runs side by side: every segment has a figure of each.
"$fogcomp" compare static.model run1.csv run2.csv --model rate.model >both.txt
[[ $(grep -c '^  all ' both.txt) == 2 ]] || fail "$(cat both.txt)"
says both.txt 'by a constant alone +by rate\.model +by static\.model'
"$fogcomp" compare static.model run1.csv run2.csv --model rate.model --json >both.json
holds both.json '.models[1].model == "rate.model"'
for run in 0 1; do
  holds both.json ".models[1].runs[$run].drift_left_dph < .models[0].runs[$run].drift_left_dph"
done
holds both.json '.models[0].runs[1].residual_rms_dph == .runs[1].residual_rms_dph' # the contract's: the first model's

# A run that leaves the training: faster ramps, later begin.
awk -F, -v OFS=, 'NR > 1 && $1 !~ /^#/ && $1 + 0 == $1 { $1 = $1 / 4 } { print }' run1.csv >fast.csv
"$fogcomp" compare rate.model fast.csv >fast.txt
says fast.txt 'warning: .*ramps beyond the trained'
! grep warning static.txt || fail "warns on its own training run"
awk -F, 'NR == 1 || $1 !~ /^[0-9]/ || $1 >= 7200' run1.csv >late.csv
"$fogcomp" fit late.csv -o late.model --effects bias,bias_temperature >/dev/null
"$fogcomp" compare late.model run1.csv >late.txt
says late.txt 'warning: .*sooner after power-on'
echo "ladder: static -> rate term, drift left $(value both.json '.models[0].runs[1].drift_left_dph') ->" \
  "$(value both.json '.models[1].runs[1].drift_left_dph') deg/h on the run held out"
