#!/usr/bin/env bash
# renew.sh FOGCOMP: draws docs/example.png anew: the README's real recording as `fogcomp compare --report` shows it, by
# headless Chromium. Needs a fogcomp that was built with npm, node and chromium.
set -euo pipefail
fogcomp=$(realpath "${1:?usage: renew.sh FOGCOMP}")
docs=$(realpath "$(dirname "$0")")
recording=$docs/examples/mems_chamber.csv
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

"$fogcomp" fit "$recording" -o cubic.model --effects bias,bias_temperature:order=3 >/dev/null
"$fogcomp" add cubic.model thermal_lag aging "$recording" -o mems.model >/dev/null
"$fogcomp" compare cubic.model "$recording" --model mems.model --report page.html >/dev/null
node "$docs/../tests/report/picture.mjs" chromium page.html example.png 0 2
mv example.png "$docs/example.png"
ls -l "$docs/example.png"
