#!/usr/bin/env bash
# ladder_of_recording.sh FOGCOMP RECORDING MAX_LEFT: of what a static model leaves of a real recording, the ladder of
# `diagnose` leaves at most the share MAX_LEFT. Exit code 77, "skipped", where the recording is not there.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: ladder_of_recording.sh FOGCOMP RECORDING MAX_LEFT}") recording=$2 max_left=$3
[[ -f $recording ]] || { echo "skipped: no recording at $recording"; exit 77; }
recording=$(realpath "$recording")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

"$fogcomp" fit "$recording" -o gyro.model --effects bias,bias_temperature:order=3 >/dev/null
"$fogcomp" diagnose gyro.model "$recording" --max-effects 4 -o ladder.model --json >ladder.json
first=$(value ladder.json residual_rms_dph) last=$(value ladder.json last residual_rms_dph)
echo "$first -> $last deg/h rms"
awk -v first="$first" -v last="$last" -v max="$max_left" \
  'BEGIN { exit !(first > 0 && last > 0 && last <= max * first) }' || fail "it ends at $last of $first"
