#!/usr/bin/env bash
# workbench.sh FOGCOMP DRIVER work|files [SHOTS]: the workbench's page in Chromium, with a mouse and a keyboard. Work: the
# README's loop, a random session whose commands make the same files in a shell, masked rows, a screen reader, a narrow
# window. Files: hostile names, an engine that traps, 60,000 rows, a rate table, columns that are not clear, large files.
# Screenshots go to the folder SHOTS.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: workbench.sh FOGCOMP DRIVER work|files [SHOTS]}")
driver=$(realpath "${2:?usage: workbench.sh FOGCOMP DRIVER work|files [SHOTS]}")
half=${3:?usage: workbench.sh FOGCOMP DRIVER work|files [SHOTS]}
shots=${4:+$(realpath "$4")}
needs /usr/bin/chromium node "$driver/node_modules/puppeteer-core/package.json"
enter_scratch
needs_engine

cp "$here/../../docs/examples/mems_chamber.csv" mems.csv
"$fogcomp" fit mems.csv -o cubic.model --effects bias,bias_temperature:order=3 >/dev/null
"$fogcomp" workbench cubic.model mems.csv -o loop.html >/dev/null
"$fogcomp" simulate -o run.csv >/dev/null
"$fogcomp" simulate -o other.csv --profile reversed --seed 2 >/dev/null
"$fogcomp" workbench run.csv --holdout other.csv -o session.html >/dev/null
effects=bias,bias_temperature:order=2,temperature_rate,temperature_rate_product
awk -F, -v OFS=, '/^[0-9]/ && $1 >= 26000 { $3 += 0.3 } { print }' run.csv >stepped.csv
"$fogcomp" fit stepped.csv -o stepped.model --effects $effects >/dev/null
"$fogcomp" workbench stepped.model stepped.csv -o stepped.html >/dev/null
hostile='<img src=x onerror=document.title="gone">.csv'
awk -F, -v OFS=, '/^time_s/ { print "time_s", "temperature_degc", "<b>rate</b> [deg/h]"; next } 1' mems.csv >"$hostile"
"$fogcomp" workbench "$hostile" -o hostile.html --columns 'rate=<b>rate</b> [deg/h]' >/dev/null
"$fogcomp" fit run.csv -o plain.model --effects bias,bias_temperature >/dev/null
"$fogcomp" workbench plain.model run.csv other.csv -o two_runs.html >/dev/null
"$fogcomp" simulate -o fast.csv --rate 5 >/dev/null # 297,750 samples: the page has their means over 1 s
"$fogcomp" simulate -o table.csv --profile rate_table --effect scale_factor:peak=1 >/dev/null
"$fogcomp" fit table.csv -o still.model --effects bias,bias_temperature:order=3 >/dev/null
"$fogcomp" workbench still.model table.csv -o table.html >/dev/null
"$fogcomp" add cubic.model thermal_lag mems.csv -o grown.model --report report.html >/dev/null 2>&1
# As a logger writes it: two axes, and units that are not said.
awk -F, -v OFS=';' '/^#/ { next } /^time_s/ { print "Stamp", "Chamber temperature", "Gyro_X", "Gyro_Y"; next }
  { print $1, $2, $3 / 2, $3 }' mems.csv >foreign.csv
echo "nothing to see here" >no_recording.csv
awk -F, -v OFS=, '/^[0-9]/ { $2 += 273.15 } { print }' mems.csv >kelvin.csv
"$fogcomp" simulate -o loud.csv --preset tactical >/dev/null
for page in *.html; do
  (($(stat -c %s $page) < 2500000)) || fail "$page is $(stat -c %s $page) bytes"
done

"$fogcomp" workbench fast.csv -o long.html >/dev/null 2>note.txt
grep -q "has 297750 samples; the workbench has their 59550 means over 1 s" note.txt

node "$here/workbench.mjs" "$driver" "$shots" "$half"
[[ $half == work ]] || exit 0

in_lines() { node -p 'JSON.stringify(JSON.parse(fs.readFileSync(0)), null, 1)'; }
# The diagnosis in a shell, of one run and of two, where the verdict hangs on simulated noise.
"$fogcomp" diagnose cubic.model mems.csv --json |
  in_lines >shell_diagnosis.json
"$fogcomp" diagnose plain.model run.csv other.csv --json | in_lines >shell_two_runs.json
# The commands that the session's page shows, in a shell.
mkdir shell
cp run.csv other.csv shell
[[ -s commands.txt ]] || fail "the page shows no commands"
(cd shell && PATH=$(dirname "$fogcomp"):$PATH bash -euo pipefail ../commands.txt >said.txt 2>&1) ||
  fail "a command of the page ends in a shell with: $(tail -n 1 shell/said.txt)"
cd shell
made=$(sed -n '$ s/.* -o \([^ ]*\).*/\1/p' ../commands.txt)
"$fogcomp" export "$made" -o made.h >/dev/null
"$fogcomp" apply "$made" run.csv -o made.csv >/dev/null
"$fogcomp" history "$made" --report made.html >/dev/null 2>&1
cd ..
node "$here/compare_outputs.mjs" page.model "shell/$made" page.h shell/made.h page.csv shell/made.csv page.html \
  shell/made.html page_diagnosis.json shell_diagnosis.json page_two_runs.json shell_two_runs.json
