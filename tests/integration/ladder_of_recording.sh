#!/usr/bin/env bash
# ladder_of_recording.sh FOGCOMP RECORDING MAX_LEFT [OTHER]: of what a static model leaves of a real recording, the
# ladder of `diagnose` leaves at most the share MAX_LEFT. With OTHER, a second axis recorded at the same time, of the
# axis half-way between the first and the opposite of the second: (first - second) / sqrt(2). Exit code 77, "skipped",
# where a recording is not there.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: ladder_of_recording.sh FOGCOMP RECORDING MAX_LEFT [OTHER]}") recording=$2 max_left=$3
other=${4:-}
for file in "$recording" ${other:+"$other"}; do
  [[ -f $file ]] || { echo "skipped: no recording at $file"; exit 77; }
done
recording=$(realpath "$recording")
[[ -z $other ]] || other=$(realpath "$other")
enter_scratch

if [[ -n $other ]]; then
  paste -d, "$recording" "$other" | awk -F, '/^#/ { next } /^time_s/ { print $1 "," $2 "," $3; next }
    $1 != $4 { print "rows of different times" >"/dev/stderr"; exit 1 }
    { printf "%s,%s,%.3f\n", $1, $2, ($3 - $6) / sqrt(2) }' >between.csv
  recording=between.csv
fi

"$fogcomp" fit "$recording" -o gyro.model --effects bias,bias_temperature:order=3 >/dev/null
"$fogcomp" diagnose gyro.model "$recording" --max-effects 4 -o ladder.model --json >ladder.json
value ladder.json '"\(.residual_rms_dph) -> \(.last.residual_rms_dph) deg/h rms"'
holds ladder.json ".last.residual_rms_dph > 0 and .last.residual_rms_dph <= $max_left * .residual_rms_dph"
