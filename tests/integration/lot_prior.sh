#!/usr/bin/env bash
# lot_prior.sh FOGCOMP: what nine sisters teach makes a run of 1.5 h leave less on a programme that no model has seen. A
# gyro unlike them keeps its own values, and that is said. Its own prior never contains a gyro. What is no lot is refused
# in one line.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: lot_prior.sh FOGCOMP}")
enter_scratch

effects=bias,bias_temperature,temperature_rate,shupe
printf 'start 20 degC\nramp to -40 degC at 2 degC/min\nramp to 60 degC at 2 degC/min\nsoak 10 min\n' >short.profile
# gyro FILE SEED RATE OPTIONS...: a run of a gyro of the lot, whose coefficients differ by some percent.
gyro() {
  local file=$1 seed=$2 rate=$3
  shift 3
  mkdir -p "$(dirname "$file")"
  "$fogcomp" simulate -o "$file" --seed "$seed" --preset none --effect bias:value_dph=0.5 \
    --effect "shupe:asymmetry_m=0.$((20 + seed % 3))" --effect "temperature_rate:coefficient=$rate" \
    --effect "bias_temperature:slope=$((28 + seed % 5))e-5,curvature=1e-5" "$@" >said.txt
}
noise=(--noise white=0.002,flicker=0.003)
error() { "$fogcomp" compare "$1" "$2" --json | jq -r '.runs[0].residual_rms_dph'; }
below() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a < b) }' || fail "$3: $1, not below $2"; }

for number in 1 2 3 4 5 6 7 8 9; do gyro "gyros/S$number/run.csv" $number "0.10$number" "${noise[@]}"; done
"$fogcomp" batch gyros -o out --effects $effects --jobs 2 --lot >batch.txt
says batch.txt '^out/gyros.lot: what 9 gyros teach a further one; next: fogcomp fit RUN -o MODEL --lot out/gyros.lot$'
"$fogcomp" batch gyros -o out --effects $effects --jobs 2 --lot --json >batch.json
holds batch.json '.lot_file == "out/gyros.lot"'
"$fogcomp" batch gyros -o out --effects $effects --jobs 2 --json >batch.json
holds batch.json '.lot_file == null'

# A tenth gyro.
gyro now.csv 10 0.104 "${noise[@]}" --profile short.profile
gyro unseen.csv 10 0.104 --profile reversed
"$fogcomp" fit now.csv -o alone.model --effects $effects >said.txt
"$fogcomp" fit now.csv -o new.model --lot out/gyros.lot --json >new.json
below "$(error new.model unseen.csv)" "$(error alone.model unseen.csv)" 'with the lot'
holds new.json '.prior.file == "out/gyros.lot" and .prior.gyros == 9'
holds new.json '.prior.unknowns | all(.moved | not)'

# The same as a gyro of a production line; in its own lot a gyro has the others as its prior.
mkdir -p line/N1
cp now.csv line/N1/run.csv
"$fogcomp" calibrate line/N1 -o calibrated --prior-lot out/gyros.lot >calibrate.txt
cmp <(grep ^effect new.model) <(grep ^effect calibrated/N1/N1.model) || fail 'calibrate --prior-lot: another model'
"$fogcomp" batch gyros -o again --jobs 2 --prior-lot out/gyros.lot >again.txt
"$fogcomp" history again/S3/S3.model >history.txt
says history.txt 'prior: .*gyros.lot [(]8 gyros[)]'
status=0
"$fogcomp" batch gyros -o again --lot --prior-lot out/gyros.lot >said.txt 2>few.txt || status=$?
((status == 2)) || fail "a lot of a lot: exit code $status"
says few.txt '^--lot: is of what each gyro tells alone; leave --prior-lot out'

holds new.json '[.prior.unknowns[] | select(.from_before > 0.5).name] | index("shupe.tau")'
"$fogcomp" history new.model >history.txt
says history.txt 'prior: out/gyros.lot [(]9 gyros[)]'

# Unlike its lot.
gyro unlike.csv 11 0.3 "${noise[@]}" --profile short.profile
gyro unseen_unlike.csv 11 0.3 --profile reversed
"$fogcomp" fit unlike.csv -o unlike.model --lot out/gyros.lot >unlike.txt
says unlike.txt '^  temperature_rate.K is unlike the 9 gyros of out/gyros.lot: the recordings alone tell it$'
"$fogcomp" history unlike.model >history.txt
says history.txt '[(]9 gyros[)]; temperature_rate.K by [+][0-9.]* sigma'
"$fogcomp" fit unlike.csv -o alone.model --effects $effects >said.txt
below "$(error unlike.model unseen_unlike.csv)" "$(error alone.model unseen_unlike.csv)" 'of a gyro unlike its lot'

# Its own prior never contains a gyro: known by its number, and by its recording.
"$fogcomp" fit now.csv -o own.model --lot out/gyros.lot --serial S3 --json >own.json
holds own.json '.prior.gyros == 8'
cp gyros/S3/run.csv copy.csv
"$fogcomp" fit copy.csv -o own.model --lot out/gyros.lot --json >own.json
holds own.json '.prior.gyros == 8'

sed 's/^gyro S1 /gyro S2 /' out/gyros.lot >damaged.lot
refuses_fit now.csv 'damaged.lot: is damaged' --lot damaged.lot
refuses_fit now.csv 'new.model: is a model, not a lot; --prior takes' --lot new.model
refuses_fit now.csv 'is not a fogcomp lot; fogcomp batch --lot makes one' --lot now.csv
refuses_fit now.csv 'out/gyros.lot: is not a fogcomp model' --prior out/gyros.lot
refuses_fit now.csv 'determined by out/gyros.lot' --lot out/gyros.lot --effects bias
refuses_fit now.csv 'determined by new.model' --lot out/gyros.lot --prior new.model
rm -r gyros/S8 gyros/S9
status=0
"$fogcomp" batch gyros -o few --effects $effects --jobs 2 --lot >said.txt 2>few.txt || status=$?
((status == 2)) || fail "a lot of 7: exit code $status"
says few.txt '^--lot: needs at least 8 gyros, here are 7'
[[ ! -e few ]] || fail 'a lot of 7 is begun'
echo "a lot teaches"
