#!/usr/bin/env bash
# refused_name.sh FOGCOMP: charge in the optics, which the catalogue does not have, looks like a glass transition with
# certainty; out of sample that raises the error, and nothing else lowers it. It is not named.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: refused_name.sh FOGCOMP}")
enter_scratch

"$fogcomp" simulate -o run.csv --profile minor_loops --seed 56001728 --preset none \
  --noise white=0.0017,flicker=0.0025 --effect housing:housing_j_per_k=596,to_air_w_per_k=0.615,self_heating_w=2.19 \
  --effect bias --effect bias_temperature:slope=-5.7e-4,cubic=-1.8e-7 --effect temperature_rate:coefficient=0.084 \
  --effect pyroelectric:threshold_k=7.7,leak_s=550,scale=16 >/dev/null
"$fogcomp" fit run.csv -o gyro.model --effects bias,bias_temperature:order=3,temperature_rate >/dev/null
"$fogcomp" diagnose gyro.model run.csv >said.txt
head -n 2 said.txt
awk '$1 == "glass_transition" { exit !($2 > 0.92) }' said.txt || fail "not taken for a glass transition: $(cat said.txt)"
grep -q '^something is missing .*: what looks like glass_transition does not hold out of sample$' said.txt ||
  fail "$(cat said.txt)"
grep -q '^  next: nothing to add: glass_transition was tried and refused, does not help out of sample' said.txt ||
  fail "$(cat said.txt)"
