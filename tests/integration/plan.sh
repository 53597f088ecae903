#!/usr/bin/env bash
# plan.sh FOGCOMP: a programme is planned, simulated and fitted. On a programme that neither model has seen, the
# planned one of equal length leaves less than the reference paper's, as it was foretold. What cannot be planned is
# refused in one line.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: plan.sh FOGCOMP}")
enter_scratch

effects=bias,bias_temperature,temperature_rate,shupe,warm_up
box=(--use T:-40..60,ramp:1)
"$fogcomp" plan --effects $effects "${box[@]}" --hours 16.5 -o plan.profile --json >plan.json
holds plan.json '.profile == "plan.profile" and .hours > 16.4 and .hours < 16.6'
holds plan.json '.steps[-1].sigma_dph == .sigma_dph and (.visible | map(.effect) | index("thermal_hysteresis"))'

"$fogcomp" plan --compare plan.profile paper --effects $effects "${box[@]}" --json >foretold.json
holds foretold.json '.programmes[0].sigma_dph < 0.9 * .programmes[1].sigma_dph'
holds foretold.json ".programmes[0].sigma_dph - $(value plan.json .sigma_dph) | fabs < 1e-12"
"$fogcomp" plan --compare plan.profile paper --report page.html >foretold.txt
says foretold.txt '^  paper  *16.5 h'

# A model is named before the programmes.
"$fogcomp" simulate -o paper.csv >/dev/null
"$fogcomp" fit paper.csv -o paper.model --effects bias,bias_temperature >/dev/null
"$fogcomp" plan paper.model --compare paper >foretold.txt
says foretold.txt '^  effects: *bias, bias_temperature$'

# Simulated: the mean square error of three gyros on the moves of another programme.
printf 'start 20 degC\nrandom_steps -35 degC to 55 degC at 1 degC/min every 70 min for 12 h\n' >unseen.profile
gyro=(--without polarization_ripple --without temperature_rate_product --effect shupe:asymmetry_m=0.2)
for seed in 1 2 3; do
  "$fogcomp" simulate -o unseen.csv --profile unseen.profile "${gyro[@]}" --noise none --seed "$seed" >/dev/null
  for programme in plan.profile paper; do
    "$fogcomp" simulate -o run.csv --profile $programme "${gyro[@]}" --seed "$seed" >/dev/null
    "$fogcomp" fit run.csv -o $programme.model --effects $effects >/dev/null
    "$fogcomp" compare $programme.model unseen.csv --json >compare.json
    value compare.json '.runs[0].residual_rms_dph' >>$programme.errors
  done
done
squares() { awk '{ sum += $1 * $1 } END { print sum }' "$1"; }
awk -v a="$(squares plan.profile.errors)" -v b="$(squares paper.errors)" 'BEGIN { exit !(a < b) }' ||
  fail "planned $(paste -sd' ' plan.profile.errors), paper $(paste -sd' ' paper.errors)"

# A model plans for itself: its effects, its noise, the box of its runs.
"$fogcomp" plan paper.model --hours 2 -o own.profile >own.txt
says own.txt '^  effects: *bias, bias_temperature, temperature_rate, shupe, warm_up'
"$fogcomp" simulate -o own.csv --profile own.profile >/dev/null

# refused WORDS...: exit code 2, one line, no file.
refused() {
  local pattern=$1 status=0
  shift
  "$fogcomp" plan "$@" -o refused.profile >refused.out 2>refused.txt || status=$?
  ((status == 2)) || fail "plan $*: exit code $status"
  [[ ! -s refused.out && ! -e refused.profile ]] || fail "plan $*: an output"
  (($(wc -l <refused.txt) == 1)) || fail "plan $*: $(cat refused.txt)"
  says refused.txt "$pattern" "plan $*"
}
refused 'more than the chamber does' --use T:-55..60
refused 'more than the chamber does' --use ramp:5
refused 'is no range' --chamber T:60..-40
refused 'none of T, ramp, rate' --use humidity:3
refused 'hours' --hours 0
refused 'needs input rates' --effects bias,scale_factor
refused 'white' --noise white=0
refused 'has effects' paper.model --effects bias
refused 'does not exist|cannot|no such' absent.model
refused 'is a model, where plan expects' paper.model plan.profile.model
status=0
"$fogcomp" plan --compare papr 2>refused.txt || status=$?
((status == 2)) || fail "exit code $status"
says refused.txt "did you mean 'paper'"
