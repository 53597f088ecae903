#!/usr/bin/env bash
# dwell_table.sh FOGCOMP: a table of means at steady temperatures, lines in any order, is fitted and judged as what it
# is: it gives the gyro's bias and scale factor over temperature, and nothing that time or ramps would show.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: dwell_table.sh FOGCOMP}")
enter_scratch

# table FILE SEED TURNED: 24 lines, bias 5 + 0.3 (T - 20) + 0.004 (T - 20)^2 deg/h, noise 0.5; TURNED: every second
# line at 50 deg/s, with a scale factor of 1 + 400 ppm.
table() {
  random_awk -v turned="$3" -v seed="$2" 'BEGIN {
    seed_draws(seed)
    print "Temp [degC];Table rate [deg/s];Mean rate [deg/h]"
    for (i = 0; i < 24; i++) {
      k = (7 * i + 3) % 24 # in no order
      T = -40 + 5 * k
      W = turned && k % 2 ? 50 : 0
      x = T - 20
      printf "%.2f;%g;%.4f\n", T, W, W * 3600 * (1 + 400e-6) + 5 + 0.3 * x + 0.004 * x * x + 0.5 * normal()
    }
  }' >"$1"
}
columns=(--table --columns 'input_rate=Table rate [deg/s],rate=Mean rate [deg/h]')

table still.csv 1 0
status=0
"$fogcomp" info still.csv 2>said.txt || status=$?
[[ $status == 2 ]] || fail "a table without times: exit code $status"
says said.txt 'without times: --rate HZ \(even samples\) or --table \(means at steady temperatures\)'

"$fogcomp" info still.csv "${columns[@]}" >info.txt 2>&1
says info.txt '^a table: 24 means at -40.0 to 75.0 degC, which scatter by'
says info.txt "next: fogcomp fit still.csv -o gyro.model --effects bias,bias_temperature:order=2 --columns .* --table"
"$fogcomp" info still.csv "${columns[@]}" --json 2>/dev/null >info.json
holds info.json '.rows == 24 and .gaps == 0 and .course == "table" and .noise_floor_dph == null'

# The coefficients are those of the lines' own temperatures, in whatever order they stand.
"$fogcomp" fit still.csv "${columns[@]}" -o still.model --effects bias,bias_temperature:order=2 --json 2>/dev/null >a.json
{
  head -n 1 still.csv
  tail -n +2 still.csv | sort -g
} >sorted.csv
"$fogcomp" fit sorted.csv "${columns[@]}" -o sorted.model --effects bias,bias_temperature:order=2 --json 2>/dev/null >b.json
holds a.json '.rows == 24 and .residual_rms_dph > 0.3 and .residual_rms_dph < 0.7'
for fit in a b; do jq -c '[.effects[].coefficients_dph[] | . * 1e4 | round]' "$fit.json" >"$fit.txt"; done
cmp a.txt b.txt || fail "the order of lines matters"
"$fogcomp" apply still.model still.csv "${columns[@]}" -o out.csv >said.txt 2>&1
[[ $(wc -l <out.csv) == 25 ]] || fail "apply: $(wc -l <out.csv) lines of 24"
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
  { x = $(at["temperature_degc"]) - 20; d = $(at["drift_dph"]) - (5 + 0.3 * x + 0.004 * x * x); s += d * d }
  END { exit !(NR == 25 && sqrt(s / 24) < 0.4) }' out.csv || fail "the drift is wrong: $(cat out.csv)"

# What a table cannot show is refused, and so are times.
for effect in temperature_rate warm_up thermal_hysteresis thermal_lag glass_transition; do
  status=0
  "$fogcomp" fit still.csv "${columns[@]}" -o no.model --effects "bias,$effect" >said.txt 2>&1 || status=$?
  [[ $status == 2 && ! -e no.model ]] || fail "$effect of a table: exit code $status, $(cat said.txt)"
done
for option in '--rate 10' '--mask 0..5' '--join still.csv'; do
  status=0
  # shellcheck disable=SC2086 # two words
  "$fogcomp" fit still.csv "${columns[@]}" $option -o no.model --effects bias >said.txt 2>&1 || status=$?
  [[ $status == 2 ]] || fail "--table $option: exit code $status"
  says said.txt "^${option% *}: means nothing beside --table; leave one of the two out"
done

# Judged out of sample: the curve is needed, a cubic part is not there.
"$fogcomp" fit still.csv "${columns[@]}" -o line.model --effects bias,bias_temperature:order=1 >said.txt 2>&1
says said.txt '^  next: how much of the rest is noise, so few rows do not show: fogcomp add says'
"$fogcomp" add line.model bias_temperature:order=2 still.csv "${columns[@]}" -o curve.model >said.txt 2>&1 ||
  fail "the curve is refused: $(cat said.txt)"
status=0
"$fogcomp" add curve.model bias_temperature:order=4 still.csv "${columns[@]}" -o wiggle.model >said.txt 2>&1 || status=$?
[[ $status == 1 ]] || fail "a cubic and a quartic part: exit code $status, $(cat said.txt)"

# Few means do not tell which of all effects is missing; the command that judges one is named.
status=0
"$fogcomp" diagnose line.model still.csv "${columns[@]}" >said.txt 2>&1 || status=$?
[[ $status == 2 ]] || fail "diagnose of 24 means: exit code $status"
says said.txt '24 rows .*too few; at least 60 are needed: fogcomp add judges one effect of few rows; .*a --table of more means'

# A rate table's: bias and scale factor.
table turned.csv 2 1
"$fogcomp" fit turned.csv "${columns[@]}" -o turned.model --effects bias,bias_temperature:order=2,scale_factor --json \
  2>/dev/null >c.json
holds c.json '.residual_rms_dph < 0.8'
