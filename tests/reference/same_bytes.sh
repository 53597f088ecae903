#!/usr/bin/env bash
# same_bytes.sh FOGCOMP SOURCE: the reference and the core (`fogcomp replay`) send the same bytes: on the
# golden vectors, a simulated recording with faults in it, and random models on random streams full of faults. And they
# refuse the same tables for their cost.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
usage="usage: same_bytes.sh FOGCOMP SOURCE"
fogcomp=$(realpath "${1:?$usage}") source=$(realpath "${2:?$usage}")
here=$source/tests/reference golden=$source/tests/golden
export PYTHONDONTWRITEBYTECODE=1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

# same NAME: NAME_table.bin on NAME_stream.bin.
same() {
  "$fogcomp" replay "$1_table.bin" "$1_stream.bin" -o core.bin >said.txt 2>&1 || fail "$1: $(cat said.txt)"
  python3 "$here/reference.py" "$1_table.bin" "$1_stream.bin" -o reference.bin >said.txt || fail "$1: $(cat said.txt)"
  cmp core.bin reference.bin || fail "$1: core and reference differ"
}

python3 "$here/reference.py" --vectors "$golden/spec_functions.txt" --stream-vectors "$golden/spec_stream.txt" \
  >said.txt ||
  fail "$(grep -v ' of \([0-9]*\) ' said.txt)"

python3 "$here/random_cases.py" . 1 20
for seed in $(seq -f %03.0f 20); do same "$seed"; done
# refuses TABLE: both, for what a sample costs.
refuses() {
  ! "$fogcomp" replay "$1" 001_stream.bin -o core.bin >said.txt 2>&1 || fail "$1: the core takes it"
  grep -q 'a sample may take [0-9]* instructions' said.txt || fail "$1: $(cat said.txt)"
  ! python3 "$here/reference.py" "$1" 001_stream.bin -o reference.bin 2>said.txt || fail "$1: the reference takes it"
  grep -q 'instructions are too many' said.txt || fail "$1: $(cat said.txt)"
}
for seed in $(seq 20); do python3 "$here/random_cases.py" --cost . "$seed"; done
for table in ???_dear.bin; do
  refuses "$table"
  "$fogcomp" replay "${table/dear/fits}" 001_stream.bin -o core.bin >said.txt 2>&1 || fail "$table: $(cat said.txt)"
done

printf 'start 20 degC\nsegment 20\nsoak 30 s\nramp to 25 degC at 2 degC/min\nsoak 1 min\n' >short.profile
"$fogcomp" simulate -o run.csv --seed 3 >said.txt
"$fogcomp" fit run.csv -o gyro.model --network 4 \
  --effects bias,bias_temperature,temperature_rate,shupe,polarization_ripple >said.txt
"$fogcomp" export gyro.model -o recording_table.bin --format table --output both --serial 5 >said.txt
"$fogcomp" simulate -o clean.bin --profile short.profile --rate 200 --format stream --seed 4 >said.txt
python3 "$here/random_cases.py" --damage clean.bin recording_stream.bin
same recording
(($(stat -c %s core.bin) > 40000 * 50)) || fail "the recording is short: $(stat -c %s core.bin) bytes"

echo "the same bytes on the golden vectors, a recording with faults, and 20 random models"
