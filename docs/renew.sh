#!/usr/bin/env bash
# renew.sh FOGCOMP: draws docs/example.png and docs/workbench.png anew: the README's real recording as `fogcomp compare
# --report` shows it, and on the page of `fogcomp workbench`, by headless Chromium. Needs a fogcomp that was built with
# npm, emscripten and tests (-DFOG_TESTS=ON), in its build folder, node and chromium.
set -euo pipefail
fogcomp=$(realpath "${1:?usage: renew.sh FOGCOMP}")
docs=$(realpath "$(dirname "$0")")
driver=$(dirname "$fogcomp")/tests/report/browser_driver
recording=mems_chamber.csv # beside the page: the pictures show the command line
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
cp "$docs/examples/$recording" .

"$fogcomp" fit "$recording" -o cubic.model --effects bias,bias_temperature:order=3 >/dev/null
"$fogcomp" add cubic.model thermal_lag aging "$recording" -o mems.model >/dev/null
"$fogcomp" compare cubic.model "$recording" --model mems.model --report page.html >/dev/null
node "$docs/../tests/report/picture.mjs" "$driver" page.html example.png 0 2
"$fogcomp" workbench cubic.model "$recording" -o bench.html >/dev/null
node "$docs/../tests/report/picture_of_workbench.mjs" "$driver" bench.html workbench.png
mv example.png workbench.png "$docs"
ls -l "$docs"/*.png
