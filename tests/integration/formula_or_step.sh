#!/usr/bin/env bash
# formula_or_step.sh FOGCOMP: strain that follows the square of the temperature rate, late, is hidden on a programme
# on which T dT/dt with a bias step imitates it, |dT/dt| where a step alone does, a first heat where two ripples do. The
# form is found and proposed all the same. Where T dT/dt and a step are hidden, they are named.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: formula_or_step.sh FOGCOMP}")
enter_scratch

# gyro NAME PROFILE SEED PART...: a recording of a gyro with these parts, and the model of a gyro without.
gyro() {
  local name=$1 profile=$2 seed=$3 parts=() part
  shift 3
  for part in bias bias_temperature temperature_rate:coefficient=0.054 "$@"; do parts+=(--effect "$part"); done
  "$fogcomp" simulate -o "$name.csv" --profile "$profile" --seed "$seed" --preset none \
    --noise white=0.0025,flicker=0.0007 "${parts[@]}" >/dev/null
  "$fogcomp" fit "$name.csv" -o "$name.model" --effects bias,bias_temperature:order=3,temperature_rate >/dev/null
  "$fogcomp" diagnose "$name.model" "$name.csv" --json >"$name.json"
}

# typed FILE: what the diagnosis in FILE proposes can be added.
typed() {
  eval "\"\$fogcomp\" $(sed -n 's/^  next: fogcomp //p' "$1")" >added.txt
}

# TAU SCALE SEED
finds_strain_where_a_product_and_a_step_imitate_it() {
  gyro late power_cycles "$3" "squared_lag:tau_s=$1,scale=$2"
  "$fogcomp" diagnose late.model late.csv --details | in_full >late.txt
  jq -e '.verdict == "unknown" and
    (.forms[0].name | IN("lag(lag(dTdt,tau),tau)^2", "lag(dTdt,tau)^2"))' late.json >claim.txt &&
    typed late.txt
}
share 4 6 finds_strain_where_a_product_and_a_step_imitate_it 300 8
share 4 6 finds_strain_where_a_product_and_a_step_imitate_it 600 5

names_product_and_step() { # SEED
  gyro both paper "$1" temperature_rate_product:scale=5 bias_step:peak=0.05
  jq -e '.effect == "temperature_rate_product" and .verdict == "missing_effect"' both.json >claim.txt
}
share 4 6 names_product_and_step

finds_a_magnitude_where_a_step_imitates_it() { # SEED
  "$fogcomp" simulate -o size.csv --profile power_cycles --seed "$1" --preset none --rate 0.1 --noise white=0.0014 \
    --effect bias --effect bias_temperature --effect temperature_rate:coefficient=-0.027 \
    --effect sensor:lag_s=9.7,resolution_k=0.0625 --effect rate_nonlinearity:form=magnitude,scale=6 >/dev/null
  "$fogcomp" fit size.csv -o size.model --effects bias,bias_temperature:order=2,temperature_rate >/dev/null
  "$fogcomp" diagnose size.model size.csv --details | in_full >size.txt
  grep -q '^something is missing: what looks like bias_step does not hold out of sample$' size.txt &&
    grep -qF 'outside the catalogue it looks like abs(dTdt)' size.txt && typed size.txt
}
share 3 6 finds_a_magnitude_where_a_step_imitates_it

# A coil's first heat with two rises, which two ripples imitate, or one beside a step.
finds_a_first_heat_where_ripples_imitate_it() { # SEED
  "$fogcomp" simulate -o ripple.csv --profile power_cycles --seed "$1" --preset none --rate 0.1 --noise white=0.0024 \
    --effect housing:housing_j_per_k=573,to_air_w_per_k=0.833 --effect bias --effect bias_temperature \
    --effect temperature_rate:coefficient=0.12 --effect warmest_so_far:scale=57.7 >/dev/null
  "$fogcomp" fit ripple.csv -o ripple.model --effects bias,bias_temperature:order=2,temperature_rate >/dev/null
  "$fogcomp" diagnose ripple.model ripple.csv --details | in_full >ripple.txt
  grep -q '^something is missing' ripple.txt &&
    grep -qF 'outside the catalogue it looks like highest(T)' ripple.txt && typed ripple.txt
}
share 5 6 finds_a_first_heat_where_ripples_imitate_it
