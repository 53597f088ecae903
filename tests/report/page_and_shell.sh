#!/usr/bin/env bash
# page_and_shell.sh FOGCOMP: what the page calculates is what the shell calculates, to 1.5e-8 of a figure: every command of
# the page's engine, run by Node, on one, two and three runs, a holdout, a rate table, a real recording, with and
# without masks.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: page_and_shell.sh FOGCOMP}")
needs node
enter_scratch
needs_engine

cp "$here/../../docs/examples/mems_chamber.csv" mems.csv
"$fogcomp" simulate -o run.csv >/dev/null
"$fogcomp" simulate -o other.csv --profile reversed --seed 2 >/dev/null
"$fogcomp" simulate -o third.csv --seed 3 >/dev/null
"$fogcomp" simulate -o table.csv --profile rate_table --effect scale_factor:peak=1 >/dev/null
node "$here/page_and_shell.mjs" "$fogcomp" empty.html
