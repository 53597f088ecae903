#!/usr/bin/env bash
# equal_figures.sh FOGCOMP: what two commands print for the same thing is the same: residual, scatter, floor and rows
# left out of one recording and model, with spikes in it and without, and where the board's delay makes most of the
# error.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: equal_figures.sh FOGCOMP}")
enter_scratch

# close A B WHAT [TOLERANCE]: within TOLERANCE of A.
close() {
  [[ $1 =~ ^-?[0-9] && $2 =~ ^-?[0-9] ]] || fail "$3: no number in '$1' and '$2'"
  awk -v a="$1" -v b="$2" -v tolerance="${4:-1e-9}" \
    'BEGIN { d = a - b; if (d < 0) d = -d; exit !(d <= tolerance * (a < 0 ? -a : a)) }' ||
    fail "$3: $1 and $2"
}

# same RUN EFFECT...: fits RUN, and holds every command's figures against those of `compare`.
same() {
  local run=$1
  shift
  "$fogcomp" fit "$run" -o gyro.model "$@" --json >fit.json
  "$fogcomp" compare gyro.model "$run" --json >compare.json
  "$fogcomp" info "$run" --average "$(value compare.json '.runs[0].row_s')" --json >info.json
  "$fogcomp" diagnose gyro.model "$run" --average "$(value compare.json '.runs[0].row_s')" --json >diagnose.json
  "$fogcomp" history gyro.model --json >history.json
  "$fogcomp" add gyro.model warm_up "$run" -o next.model --force --json >add.json
  mkdir -p gyros/G1
  cp "$run" gyros/G1/run.csv
  rm -rf results
  "$fogcomp" batch gyros -o results "$@" --json >batch.json
  local residual raw floor outliers
  residual=$(value compare.json '.runs[0].residual_rms_dph')
  raw=$(value compare.json '.runs[0].raw_std_dph')
  floor=$(value compare.json '.runs[0].noise_floor_dph')
  outliers=$(value compare.json '.runs[0].outliers')
  close "$residual" "$(value fit.json .residual_rms_dph)" "$run: residual of fit"
  close "$residual" "$(value history.json '.steps[0].rms_after_dph')" "$run: residual of history"
  close "$residual" "$(value add.json '.runs[0].rms_before_dph')" "$run: residual of add"
  close "$residual" "$(value diagnose.json .as_given.residual_rms_dph)" "$run: residual of diagnose"
  close "$(value compare.json '.runs[0].residual_rms_without_delay_dph')" \
    "$(value diagnose.json .as_given.residual_rms_without_delay_dph)" "$run: residual without delay"
  close "$residual" "$(figure fit_rms_dph)" "$run: residual of batch" 1e-6
  close "$raw" "$(figure fit_raw_std_dph)" "$run: raw std of batch" 1e-6
  close "$raw" "$(value fit.json .raw_std_dph)" "$run: raw std of fit"
  close "$raw" "$(value history.json '.steps[0].rms_before_dph')" "$run: raw std of history"
  close "$raw" "$(value info.json .std_dph)" "$run: std of info"
  close "$(value compare.json '.runs[0].raw_mean_dph')" "$(value info.json .mean_dph)" "$run: mean of info"
  close "$floor" "$(value info.json .noise_floor_dph)" "$run: floor of info"
  close "$floor" "$(value diagnose.json .noise_floor_dph)" "$run: floor of diagnose"
  close "$floor" "$(value add.json '.runs[0].noise_floor_dph')" "$run: floor of add"
  close "$floor" "$(value history.json '.steps[0].noise_floor_dph')" "$run: floor of history"
  close "$floor" "$(figure fit_floor_dph)" "$run: floor of batch" 1e-6
  for file in fit info diagnose; do
    [[ $(value $file.json .outliers) == "$outliers" ]] || fail "$run: rows left out of $file"
  done
  [[ $(value add.json '.runs[0].outliers') == "$outliers" && $(figure fit_outliers) == "$outliers" ]] ||
    fail "$run: rows left out of add or batch"
  local i segments
  segments=$(value info.json '.segments | length')
  for ((i = 0; i < segments; ++i)); do
    close "$(value compare.json ".runs[0].segments[$i].raw_std_dph")" "$(value info.json ".segments[$i].std_dph")" \
      "$run: std of segment $i"
  done
}

# figure NAME: of the batch's only gyro.
figure() {
  awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) at = i } NR == 2 { print $at }' \
    results/gyros.csv
}

"$fogcomp" simulate -o clean.csv --noise outliers=0 >/dev/null
same clean.csv --effects bias,bias_temperature
clean=$(value compare.json '.runs[0].residual_rms_dph')
coefficient=$(value fit.json '.effects[0].coefficients_dph[0]')
"$fogcomp" compare gyro.model clean.csv >clean.txt
grep -q 'left out' clean.txt && fail "rows of a clean recording are left out"

# Eight spikes: neither the model nor any figure moves.
awk -F, 'NR > 1 && NR % 700 == 0 { printf "%s,%s,%s\n", $1, $2, $3 + 100000; next } { print }' clean.csv >spikes.csv
same spikes.csv --effects bias,bias_temperature
[[ $(value compare.json '.runs[0].outliers') == 8 ]] || fail "$(value compare.json '.runs[0].outliers') of 8 spikes left out"
close "$clean" "$(value compare.json '.runs[0].residual_rms_dph')" "spikes in the residual" 0.002
close "$coefficient" "$(value fit.json '.effects[0].coefficients_dph[0]')" "spikes in the model" 0.001
for command in "compare gyro.model" "diagnose --details gyro.model" info "fit -o gyro.model --effects bias"; do
  "$fogcomp" $command spikes.csv >text.txt
  grep -q '8 rows of 10 s left out' text.txt || fail "$command does not say what it leaves out: $(cat text.txt)"
done

# A rate table at 10 Hz with a new rate every 20 s. The board knows the rate of the second before: what it makes of that
# is most of its error. Rows of 1 s, of which one in twenty is late.
random_awk '
  BEGIN {
    seed_draws(7)
    print "time_s,temperature_degc,rate_dph,input_rate_dph"
    count = split("-50 -35 -20 -5 5 20 35 50", levels, " ")
    for (i = 0; i < 36000; ++i) {
      if (i % 200 == 0) rate = 3600 * levels[1 + int(count * uniform())]
      error = 5e-4 * rate + 2e-15 * rate ^ 3 + 0.5 + 20 * normal()
      printf "%.1f,%.4f,%.4f,%.1f\n", i / 10, 25 + 10 * i / 36000, rate + error, rate
    }
  }' >table.csv
same table.csv --effects bias --effect-expr 'sf = W' --effect-expr 'nl = (W/100000)^3' --average 1
with=$(value compare.json '.runs[0].residual_rms_dph') without=$(value compare.json '.runs[0].residual_rms_without_delay_dph')
awk -v with="$with" -v without="$without" 'BEGIN { exit !(with > 2 * without) }' || fail "delay: $with, $without"
"$fogcomp" compare gyro.model table.csv >compare.txt
"$fogcomp" diagnose gyro.model table.csv >diagnose.txt
for file in compare.txt diagnose.txt; do
  figures=("$(LC_ALL=C printf %.4g "$with")" "$(LC_ALL=C printf %.4g "$without")")
  said="as the board computes it, the model leaves ${figures[0]} deg/h rms; without the board's delay .* ${figures[1]}"
  says $file "$said" "both figures"
done

# Rows that alternate: the floor is no floor.
awk -F, 'NR == 1 { print; next } { printf "%s,%s,%.6f\n", $1, $2, $3 + 0.05 * cos(3.1 * NR) }' clean.csv >line.csv
"$fogcomp" fit line.csv -o line.model --effects bias,bias_temperature,temperature_rate >/dev/null
"$fogcomp" compare line.model line.csv >text.txt
grep -q 'the floor is above the residual' text.txt || fail "a floor above the residual: $(head -3 text.txt)"
echo ok
