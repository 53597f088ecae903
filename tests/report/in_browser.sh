#!/usr/bin/env bash
# in_browser.sh FOGCOMP DRIVER [SHOTS]: a report of every kind opens from its file in Chromium, wide and narrow, light
# and dark: curves drawn, nothing wider than the window, zoom linked, printable, a silent console, no request.
# Screenshots and prints go to the folder SHOTS.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: in_browser.sh FOGCOMP DRIVER [SHOTS]}")
driver=$(realpath "${2:?usage: in_browser.sh FOGCOMP DRIVER [SHOTS]}")
shots=${3:+$(realpath "$3")}
needs /usr/bin/chromium node "$driver/node_modules/puppeteer-core/package.json"
enter_scratch

"$fogcomp" simulate -o run_degC.csv --seed 1 >/dev/null
"$fogcomp" simulate -o second.csv --seed 2 --profile reversed >/dev/null
"$fogcomp" info run_degC.csv --report info.html >/dev/null
if grep -q "^<p>No plots here" info.html; then
  echo "skipped: this fogcomp was built without npm, its reports have no plots"
  exit 77
fi
effects=bias,bias_temperature
"$fogcomp" fit run_degC.csv -o static.model --effects $effects >/dev/null
"$fogcomp" fit run_degC.csv second.csv -o rate.model --effects $effects,temperature_rate --network 3 \
  --report fit.html --json >fit.json
"$fogcomp" compare rate.model run_degC.csv second.csv --report compare.html --json >compare.json
"$fogcomp" compare static.model run_degC.csv --model rate.model --report models.html --json >models.json
"$fogcomp" diagnose static.model run_degC.csv --max-effects 2 --report diagnose.html --json >diagnose.json
"$fogcomp" add static.model temperature_rate run_degC.csv --holdout second.csv -o y.model --report add.html \
  --json >add.json
"$fogcomp" paper --models polynomial --epochs 100 --iterations 3 --report paper.html >/dev/null

# A lot with one gyro far off the others.
mkdir -p gyros/G1 gyros/SN0042 gyros/loud
cp run_degC.csv gyros/G1
cp second.csv gyros/SN0042
awk -F, -v OFS=, 'NR > 1 { $3 *= 50 } { print }' run_degC.csv >gyros/loud/run.csv
"$fogcomp" batch gyros -o lot --effects $effects >/dev/null
mv lot/index.html batch.html

# A rate table: 60 ppm of scale factor error, and a light power on which nothing depends.
awk -F, -v OFS=, 'NR == 1 { print $0, "input_rate_dph", "light_power_uw"; next }
  { w = 5000 * sin($1 / 900); print $1, $2, $3 + w * 1.00006, w, 30 + sin($1 / 5000) }' \
  OFMT=%.8g run_degC.csv >table.csv
"$fogcomp" compare static.model table.csv --report input.html >/dev/null
"$fogcomp" diagnose static.model table.csv --report input_diagnose.html >/dev/null

# Columns, not rows, decide how large a page is: 300,000 samples here, as 11.9 million (README, Reports).
"$fogcomp" simulate -o fast.csv --rate 5 >/dev/null
"$fogcomp" info fast.csv --report fast.html >/dev/null
"$fogcomp" compare static.model fast.csv --report fast_compare.html >/dev/null
# With the workbench's engine, but for what is data: the recordings that it carries and the values of the plots.
for page in *.html; do
  bytes=$(grep -v -e '^<script type="text/plain" data-file=' -e '^<script type="application/json" id="plots">' \
    $page | wc -c)
  ((bytes < 2500000)) || fail "$page is $bytes bytes"
  values=$(grep '^<script type="application/json" id="plots">' $page | wc -c)
  ((values < 1000000)) || fail "$page has $values bytes of values to plot"
done

failed=0
node "$here/check_pages.mjs" "$driver" . || failed=1
node "$here/look_at_pages.mjs" "$driver" "$shots" info.html=4 fit.html=26 compare.html=26 models.html=13 \
  diagnose.html=6 add.html=8 paper.html=7 batch.html=1 fast.html=5 input.html=16 input_diagnose.html=6 || failed=1
exit $failed
