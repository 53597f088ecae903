#!/usr/bin/env bash
# memory.sh FOGCOMP: a recording of a million blocks of 1 s (12 days; a longer one is averaged down to fewer rows as it
# is read) is fitted in 420 MB of address space: the blocks are held once, their signals in half of that. A model of
# 60,000 rows of 1 s is diagnosed in 250 MB, in rows of 10 s; asked to take those of 1 s, in 430 MB.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: memory.sh FOGCOMP}")
enter_scratch

random_awk 'BEGIN {
  seed_draws(1)
  print "time_s,temperature_degc,rate_dph"
  for (i = 0; i < 1000000; ++i) {
    degc = 20 + 30 * sin(i / 5000)
    printf "%d,%.3f,%.5f\n", i, degc, 0.5 + 0.002 * degc + 0.2 * (uniform() - uniform())
  }
}' >long.csv
(ulimit -v 420000 && "$fogcomp" fit long.csv -o long.model --effects bias,bias_temperature --average 10) >said.txt ||
  fail "the fit needs more memory: $(cat said.txt)"
grep -q '^  100000 rows of 10 s$' said.txt || fail "expected 100000 rows: $(cat said.txt)"
echo "a million blocks are fitted in 420 MB"

"$fogcomp" simulate -o day.csv --rate 1 --seed 3 >/dev/null
"$fogcomp" fit day.csv -o day.model --average 1 --effects bias,bias_temperature:order=3 >/dev/null
# On one core: every thread reserves addresses of its own.
cpu=$(awk '/^Cpus_allowed_list/ { split($2, cpus, /[,-]/); print cpus[1] }' /proc/self/status)
diagnose_in() { # KILOBYTES OPTION...
  (ulimit -v "$1" && taskset -c "$cpu" "$fogcomp" diagnose day.model day.csv "${@:2}") >said.txt 2>&1 ||
    fail "the diagnosis needs more than $1 kB: $(cat said.txt)"
  grep -q '^  next: fogcomp add day.model ' said.txt || fail "$(cat said.txt)"
}
diagnose_in 250000
diagnose_in 430000 --average 1
echo "60,000 rows are diagnosed in 250 MB, in rows of 1 s in 430 MB"
