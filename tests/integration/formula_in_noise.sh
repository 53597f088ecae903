#!/usr/bin/env bash
# formula_in_noise.sh FOGCOMP: what follows the square of a late temperature rate, on a programme without a ramp of one
# rate, looks like slow noise beside every effect of the catalogue. With formulas beside them it is found and proposed.
# Of the same gyros without it nothing is missing.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: formula_in_noise.sh FOGCOMP}")
enter_scratch

# diagnosed SEED PART...: what is said of a gyro with these parts to a model without, in said.json
diagnosed() {
  local seed=$1 parts=() part
  shift
  for part in bias bias_temperature temperature_rate:coefficient=0.08 "$@"; do parts+=(--effect "$part"); done
  "$fogcomp" simulate -o run.csv --profile random_steps --seed "$seed" --preset none \
    --noise white=0.0019,flicker=0.0008 "${parts[@]}" >/dev/null
  "$fogcomp" fit run.csv -o run.model --effects bias,bias_temperature:order=2,temperature_rate >/dev/null
  "$fogcomp" diagnose run.model run.csv --json >said.json
}

finds_the_form() { # SEED
  diagnosed "$1" squared_lag:tau_s=700,scale=60
  jq -e '.verdict == "unknown" and .forms[0].name == "lag(lag(dTdt,tau),tau)^2"' said.json >claim.txt &&
    "$fogcomp" diagnose run.model run.csv --details | in_full >said.txt &&
    grep -q '^something is missing: what looks like slow noise follows a formula' said.txt &&
    eval "\"\$fogcomp\" $(sed -n 's/^  next: fogcomp //p' said.txt)" >added.txt
}
finds_nothing_without() { # SEED
  diagnosed "$1"
  jq -e '.verdict == "none"' said.json >claim.txt
}
share 4 5 finds_the_form
share 4 5 finds_nothing_without

# The same where a random walk of the bias explains what is left as well as any effect of the catalogue.
"$fogcomp" simulate -o walk.csv --profile ramp_rates --seed 72003632 --preset none --rate 0.1 --columns all \
  --noise white=0.001188,flicker=0.003733,outliers=0.2,outlier_dph=4 --effect coil --latitude 34.27 \
  --effect housing:housing_j_per_k=464,to_air_w_per_k=0.682,self_heating_w=2.79 \
  --effect sensor:lag_s=9.8,resolution_k=0.03125,noise_k=0.0154 --effect bias:value_dph=-0.0376 \
  --effect bias_temperature:slope=-1.394e-04,curvature=1.959e-06 --effect temperature_rate:coefficient=-0.0707 \
  --effect squared_lag:tau_s=2647,scale=7.26973 >/dev/null
"$fogcomp" fit walk.csv -o walk.model --effects bias,bias_temperature:order=2,temperature_rate >/dev/null
"$fogcomp" diagnose walk.model walk.csv --json >said.json
holds said.json '.forms[0].name == "lag(lag(dTdt,tau),tau)^2" and ([.candidates[].probability] | max) < 0.1'
