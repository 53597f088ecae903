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
  holds "ladder_$row_s.json" ".added == $(value ladder_10.json .added)"
  usual=$(value left_10.json '.runs[0].residual_rms_dph')
  holds "left_$row_s.json" ".runs[0].residual_rms_dph / $usual | 0.99 < . and . < 1.01"
done

# Whatever --average asks of one look, a ladder looks in rows of its own and says so.
"$fogcomp" diagnose gyro.model "$recording" --max-effects 3 --average 1 --json >asked.json
holds asked.json ".added == $(value ladder_30.json .added)"
says asked.json 'looked at in rows of 10 s whatever --average'

# Typed step by step, the commands make the same model, which keeps its rows.
mapfile -t commands < <(jq -r '.. | .commands? // empty | .[] | select(startswith("fogcomp add "))' ladder_30.json)
((${#commands[@]} > 0)) || fail "no command in $(cat ladder_30.json)"
cp ladder.model expected.model
for command in "${commands[@]}"; do
  PATH=$(dirname "$fogcomp"):$PATH bash -c "$command" >said.txt || fail "refused: $command"
  says said.txt "judged in rows of 10 s, so that the verdict does not depend on the model's 30 s" "$command"
done
diff ladder.model expected.model || fail "the commands make another model"
says ladder.model '^average_s 30$'
