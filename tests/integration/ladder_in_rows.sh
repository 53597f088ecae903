#!/usr/bin/env bash
# ladder_in_rows.sh FOGCOMP RECORDING: whatever rows a model was fitted in, the ladder of `diagnose` on a real recording
# adds the same and ends at the same error, and its commands make its model, which keeps its rows. Exit code 77,
# "skipped", where the recording is not there.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: ladder_in_rows.sh FOGCOMP RECORDING}") recording=$2
[[ -f $recording ]] || { echo "skipped: no recording at $recording"; exit 77; }
recording=$(realpath "$recording")
enter_scratch

for row_s in 10 1 30; do
  "$fogcomp" fit "$recording" -o gyro.model --average "$row_s" --effects bias,bias_temperature:order=3 >/dev/null
  "$fogcomp" diagnose gyro.model "$recording" --max-effects 3 -o ladder.model --json >"ladder_$row_s.json"
  "$fogcomp" compare ladder.model "$recording" --average 10 --json >"left_$row_s.json"
  [[ $(value "ladder_$row_s.json" added) == "$(value ladder_10.json added)" ]] ||
    fail "in rows of $row_s s it adds $(value "ladder_$row_s.json" added)"
  awk -v left="$(value "left_$row_s.json" runs 0 residual_rms_dph)" -v usual="$(value left_10.json runs 0 residual_rms_dph)" \
    'BEGIN { exit !(usual > 0 && left < 1.01 * usual && left > 0.99 * usual) }' || fail "in rows of $row_s s it ends elsewhere"
done

# Whatever --average asks of one look, a ladder looks in rows of its own and says so.
"$fogcomp" diagnose gyro.model "$recording" --max-effects 3 --average 1 --json >asked.json
[[ $(value asked.json added) == "$(value ladder_30.json added)" ]] || fail "asked for rows of 1 s the ladder differs"
grep -q 'looked at in rows of 10 s whatever --average' asked.json || fail "the ladder does not say in which rows it looks"

# Typed step by step, the commands make the same model, which keeps its rows.
mapfile -t commands < <(grep -o '"commands":\[[^]]*\]' ladder_30.json | grep -o 'fogcomp add [^"]*')
((${#commands[@]} > 0)) || fail "it prints no commands"
cp ladder.model expected.model
for command in "${commands[@]}"; do
  PATH=$(dirname "$fogcomp"):$PATH bash -c "$command" >said.txt || fail "refused: $command"
  grep -q "judged in rows of 10 s, so that the verdict does not depend on the model's 30 s" said.txt ||
    fail "add does not say in which rows it judges"
done
diff ladder.model expected.model >/dev/null || fail "the commands make another model"
grep -q '^average_s 30$' ladder.model || fail "the model has other rows"
