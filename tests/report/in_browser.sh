#!/usr/bin/env bash
# in_browser.sh FOGCOMP [SHOTS]: a report of every kind opens from its file in Chromium, wide and narrow, light
# and dark: curves drawn, nothing wider than the window, zoom linked, printable, a silent console, no request.
# Screenshots and prints go to the folder SHOTS.
set -euo pipefail
fogcomp=$(realpath "${1:?usage: in_browser.sh FOGCOMP [SHOTS]}")
shots=${2:+$(realpath "$2")}
here=$(realpath "$(dirname "$0")")
for program in chromium node; do
  command -v $program >/dev/null || { echo "skipped: no $program here"; exit 77; }
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

"$fogcomp" simulate -o run.csv --seed 1 >/dev/null
"$fogcomp" simulate -o second.csv --seed 2 --profile reversed >/dev/null
"$fogcomp" info run.csv --report info.html >/dev/null
if grep -q "built without npm" info.html; then
  echo "skipped: this fogcomp was built without npm, its reports have no plots"
  exit 77
fi
effects=bias,bias_temperature
"$fogcomp" fit run.csv -o static.model --effects $effects >/dev/null
"$fogcomp" fit run.csv -o rate.model --effects $effects,temperature_rate --network 4 >/dev/null
"$fogcomp" compare rate.model run.csv second.csv --report compare.html >/dev/null
"$fogcomp" compare static.model run.csv --model rate.model --report models.html >/dev/null

node "$here/look_at_pages.mjs" chromium "$shots" info.html=4 compare.html=16 models.html=8
