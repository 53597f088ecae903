#!/usr/bin/env bash
# recording_to_board.sh FOGCOMP SOURCE IMAGES RECORDING DIR EFFECTS MIN_GAIN: the main job on a recording:
# fit, export, image of its own for both machines, bulk replay in QEMU, 0 bytes differ from the host's
# replay; and the model brings the rms of the drift (about its mean) down by at least MIN_GAIN.
# Exit code 77, "skipped", where the recording is not there.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$1 source=$2 images=$3 recording=$4 folder=$5 effects=$6 min_gain=$7
[[ -f $recording ]] || { echo "skipped: no recording at $recording"; exit 77; }
mkdir -p "$folder"

# Three neurons: on drifts of thousands of deg/h the integers of larger networks miss the limit of
# 0.002 deg/h, and export refuses them.
"$fogcomp" fit "$recording" -o "$folder/gyro.model" --effects "$effects" --network 3 --average 5
"$fogcomp" compare "$folder/gyro.model" "$recording" | tee "$folder/compare.txt"
# The line "all" ends with mean and std of the residual, mean and std of the raw rate, rows.
awk -v min="$min_gain" '$1 == "all" { gain = $(NF - 1) / $(NF - 3); printf "std before / after: %.2f\n", gain }
  END { exit !(gain >= min) }' "$folder/compare.txt" || fail "the drift's std falls by less than $min_gain: $(cat "$folder/compare.txt")"

# One sample per row, as the recording has them.
rate=$("$fogcomp" info "$recording" --json | jq .period_s | awk '{ printf "%.9g", 1 / $1 }')
"$fogcomp" export "$folder/gyro.model" -o "$folder/fog_model.h" --sample-rate "$rate" --output both
"$fogcomp" replay "$folder/fog_model.h" "$recording" -o "$folder/expected.bin"
"$fogcomp" stream "$folder/fog_model.h" "$recording" -o "$folder/in.bin"
"$source/tests/target/header_matches_pc.sh" "$images" "$fogcomp" "$folder/fog_model.h" "$folder" \
  "stm32f405 mps2_an386" \
  "$folder/in.bin"

# A recording has times, a stream of numbered samples has none: where samples are lost, fewer of the stream's rates are
# valid (SPEC.md, thermal_settling). Nothing but validity differs. Bytes of both frames together: 28 and 57 to 58 are
# the status, 32 to 35 and 62 to 63 the checksums.
(($(stat -c %s "$folder/expected.bin") == $(stat -c %s "$folder/expected_in.bin"))) || fail "other numbers of samples"
awk '
  { byte = ($1 - 1) % 64 }
  byte == 28 && $3 > $2 { print "more is valid in the stream: byte " $1; exit 1 }
  byte !~ /^(28|3[2-5]|5[78]|6[23])$/ { print "byte " $1 " differs: " $2 " " $3; exit 1 }' \
  <(cmp -l "$folder/expected.bin" "$folder/expected_in.bin") ||
  fail "the replays of the recording and of its stream differ in more than validity"
