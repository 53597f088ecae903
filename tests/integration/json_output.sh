#!/usr/bin/env bash
# json_output.sh FOGCOMP: --json prints exactly one JSON object with the documented keys and nothing else.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: json_output.sh FOGCOMP}")
enter_scratch

# has_keys FILE KEY...: FILE is one line, one object, and has these members: names and numbers of elements.
has_keys() {
  local lacks
  [[ $(wc -l <"$1") == 1 ]] || fail "$1 has $(wc -l <"$1") lines"
  jq -es 'length == 1 and (.[0] | type == "object")' "$1" >lacks.txt || fail "$1 is not one object: $(cat "$1")"
  lacks=$(jq -r '. as $all | $ARGS.positional[] | select(split(" ") | map(tonumber? // .) as $path |
    try ($all | getpath($path[:-1]) | has($path[-1]) | not) catch true)' "$1" --args "${@:2}")
  [[ -z $lacks ]] || fail "$1 lacks $lacks: $(cat "$1")"
  echo "$1: ok"
}

"$fogcomp" simulate -o run.csv --json >simulate.json
"$fogcomp" simulate -o other.csv --seed 2 --json >simulate_other.json
has_keys simulate.json file rows
"$fogcomp" info run.csv --json >info.json
has_keys info.json rows refused_rows period_s mean_dph std_dph noise_floor_dph "segments 0 name" \
  "segments 0 start_s" "segments 0 end_s" "segments 0 mean_dph" "segments 0 std_dph" \
  "segments 0 temperature_min_degc" "segments 0 temperature_max_degc" "allan tau_s" \
  "allan sigma_dph" "allan one_sigma_dph" angle_random_walk_dprh bias_instability_dph \
  rate_random_walk_dphrh rate_ramp_dphh quantization_deg
"$fogcomp" info - --json <run.csv | sed 's/"file":"-"/"file":"run.csv"/' >info_of_pipe.json
cmp info.json info_of_pipe.json
"$fogcomp" denoise run.csv -o denoised.csv --json >denoise.json
has_keys denoise.json output rows outliers "levels 4 noise_dph" "levels 4 threshold_dph" \
  "segments 0 raw_std_dph" "segments 0 denoised_std_dph"
"$fogcomp" fit run.csv -o gyro.model --effects bias,bias_temperature,temperature_rate --network 4 \
  --json >fit.json
has_keys fit.json residual_rms_dph "effects 2 effect"
"$fogcomp" compare gyro.model run.csv other.csv --json >compare.json
has_keys compare.json "runs 1 file" "runs 1 rows" "runs 1 raw_std_dph" "runs 1 residual_rms_dph" \
  "runs 1 residual_std_dph" "runs 1 noise_floor_dph" "runs 1 segments 0 name" \
  "runs 1 segments 0 mean_dph" "runs 1 segments 0 std_dph" extrapolated_fraction \
  "runs 1 effects 3 share" "runs 1 structure temperature_rate share_of_excess" \
  "runs 1 structure history loop_width_dph" "runs 1 autocorrelation correlation 0" \
  "runs 1 allan residual_dph 0" "runs 1 outside_training temperature_rate" "models 0 runs 1 file"
"$fogcomp" add gyro.model bias_temperature:order=3 run.csv --holdout other.csv -o next.model --force --json >add.json
has_keys add.json effect accepted reason "runs 0 file" "runs 0 rms_before_dph" "runs 0 rms_after_dph" \
  "runs 0 noise_floor_dph" "runs 1 holdout" "parameters order" "coefficients b3" \
  out_of_sample_rms_before_dph out_of_sample_rms_after_dph
"$fogcomp" history next.model --json >history.json
has_keys history.json "steps 2 action" "steps 2 data_hash" "steps 2 rms_before_dph" "steps 2 rms_after_dph" \
  "steps 2 noise_floor_dph" "steps 2 holdout_rms_after_dph" "steps 2 forced"
"$fogcomp" export gyro.model -o fog_model.h --json >export.json
has_keys export.json words rate denoised_delay_s denoised_minus_3db_hz quantization_error_dph \
  network_error_dph network_points
"$fogcomp" replay gyro.model run.csv -o out.bin --json >replay.json
has_keys replay.json frames bytes
"$fogcomp" apply gyro.model run.csv -o applied.csv --json >apply.json
has_keys apply.json output rows without_rate temperature_clamped raw_std_dph compensated_std_dph
"$fogcomp" convert run.csv -o plain.csv --json >convert.json
has_keys convert.json output rows bad_rows empty_rows period_s
cmp run.csv plain.csv
mkdir -p gyros/G1
cp run.csv gyros/G1
"$fogcomp" batch gyros -o results --effects bias,temperature_rate --json >batch.json
has_keys batch.json table index pass fail error calibrated already_done "gyros 0 gyro" "gyros 0 outcome" \
  "gyros 0 reason"
"$fogcomp" paper --gyros 2 --models polynomial --epochs 200 --iterations 5 --figures figures --json >paper.json
has_keys paper.json gyros rows raw_std_dph noise_floor_dph std_cut_bound "tables 6 pso_bp_std_printed_dph" \
  "tables 6 pso_bp_std_dph" "tables 0 denoised_mean_dph" "denoisers 5 truth_error_rms_dph" \
  "medians 0 std_cut_of_bound" "medians 2 held_out 1 truth_error_rms_dph"
for figure in 1 3 4 8 9 10; do
  [[ $(wc -l <figures/figure_$figure.csv) == 5956 ]] || fail "figure $figure is $(wc -l <figures/figure_$figure.csv) lines"
done
"$fogcomp" paper --gyros 2 --models polynomial --epochs 200 --iterations 5 --json | cmp - paper.json
"$fogcomp" effects --json >effects.json
has_keys effects.json "effects 2 equation"
