#!/usr/bin/env bash
# renew.sh FOGCOMP: draws docs/example.png anew: the README's example as `fogcomp compare --report` shows it, by
# headless Chromium. Needs a fogcomp that was built with npm, node and chromium.
set -euo pipefail
fogcomp=$(realpath "${1:?usage: renew.sh FOGCOMP}")
docs=$(realpath "$(dirname "$0")")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

"$fogcomp" simulate -o run.csv
"$fogcomp" fit run.csv -o first.model --effects bias,bias_temperature >/dev/null
"$fogcomp" add first.model temperature_rate run.csv -o gyro.model >/dev/null
"$fogcomp" add gyro.model polarization_ripple run.csv -o gyro.model >/dev/null
"$fogcomp" compare first.model run.csv --model gyro.model --report page.html >/dev/null
node "$docs/../tests/report/picture.mjs" chromium page.html example.png 0 2
mv example.png "$docs/example.png"
ls -l "$docs/example.png"
