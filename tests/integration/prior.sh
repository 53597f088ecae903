#!/usr/bin/env bash
# prior.sh FOGCOMP: three hours and a model of the gyro a year ago leave less on a programme that no model has seen than
# three hours alone. What has moved is named. What is no prior is refused in one line.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: prior.sh FOGCOMP}")
enter_scratch

effects=bias,bias_temperature,temperature_rate,shupe
plain=(--preset none --effect bias:value_dph=0.5 --effect shupe:asymmetry_m=0.2)
printf 'start 20 degC\nramp to -40 degC at 1 degC/min\nramp to 60 degC at 1 degC/min\nsoak 20 min\n' >short.profile
# gyro FILE SEED RATE SLOPE OPTIONS...: a run of the gyro with these sizes.
gyro() {
  local file=$1 seed=$2 rate=$3 slope=$4
  shift 4
  "$fogcomp" simulate -o "$file" --seed "$seed" "${plain[@]}" --effect "temperature_rate:coefficient=$rate" \
    --effect "bias_temperature:slope=$slope,curvature=1e-5" "$@" >said.txt
}
noise=(--noise white=0.002,flicker=0.003)
error() { "$fogcomp" compare "$1" "$2" --json | jq -r '.runs[0].residual_rms_dph'; }
below() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a < b) }' || fail "$3: $1, not below $2"; }

# The same gyro, a year ago and now.
gyro year_ago.csv 1 0.1 3e-4 "${noise[@]}"
gyro now.csv 2 0.1 3e-4 "${noise[@]}" --profile short.profile
gyro unseen.csv 3 0.1 3e-4 --profile reversed
"$fogcomp" fit year_ago.csv -o old.model --effects $effects --serial G1 >said.txt
"$fogcomp" fit now.csv -o alone.model --effects $effects >said.txt
"$fogcomp" fit now.csv -o new.model --prior old.model --json >new.json
# The bias is the short run's own in both.
shape() { "$fogcomp" compare "$1" "$2" --json | jq -r '.runs[0].residual_std_dph'; }
below "$(shape new.model unseen.csv)" "$(shape alone.model unseen.csv)" 'with the older model'
holds new.json '.prior.file == "old.model"'
holds new.json '.prior.unknowns | all(.moved | not)'
"$fogcomp" history new.model >history.txt
says history.txt 'prior: old.model'
grep -qx 'serial G1' new.model || fail 'the serial number is lost'

# Repaired: another coil.
gyro repaired.csv 4 0.2 3e-4 "${noise[@]}" --profile short.profile
gyro unseen_repaired.csv 3 0.2 3e-4 --profile reversed
"$fogcomp" fit repaired.csv -o repaired.model --prior old.model >repaired.txt
says repaired.txt 'temperature_rate.K.* moved from old.model'
"$fogcomp" history repaired.model >history.txt
says history.txt 'temperature_rate.K by [+][0-9.]* sigma'
"$fogcomp" fit repaired.csv -o alone.model --effects $effects >said.txt
below "$(error repaired.model unseen_repaired.csv)" \
  "$(awk -v e="$(error alone.model unseen_repaired.csv)" 'BEGIN { print 1.1 * e }')" 'after a repair'

# A model that lacked effects had them for slow noise: the bias of another gyro is not drawn towards the older one.
"$fogcomp" fit year_ago.csv -o poor.model --effects bias,bias_temperature >said.txt
for bias in 0.55 0.7; do
  gyro other.csv 5 0.001 6e-4 "${noise[@]}" --effect "bias:value_dph=$bias"
  "$fogcomp" fit other.csv -o other.model --prior poor.model --json >other.json
  "$fogcomp" fit other.csv -o alone.model --effects bias,bias_temperature --json >alone.json
  below "$(value other.json .residual_rms_dph)" "$(value alone.json '1.1 * .residual_rms_dph')" "bias $bias, not 0.5"
done

# No recording counts twice, nor a part of it.
refuses_fit year_ago.csv '^year_ago.csv: has samples to which the older model was fitted' --prior old.model
refuses_fit year_ago.csv '^year_ago.csv: has samples to which' --prior new.model
(head -n 1 year_ago.csv && sed -n 2000,4000p year_ago.csv) >part.csv
refuses_fit part.csv '^part.csv: has samples to which' --prior old.model
refuses_fit now.csv 'determined by old.model' --prior old.model --effects bias
refuses_fit now.csv 'determined by old.model' --prior old.model --derivative-tau 60
refuses_fit now.csv 'is of gyro G1, not of G2' --prior old.model --serial G2
"$fogcomp" fit year_ago.csv -o network.model --effects bias --network 2 --force-network >said.txt
refuses_fit now.csv 'has a network' --prior network.model
