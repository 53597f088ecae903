#!/usr/bin/env bash
# Package:  Debian 12 miller 6.6.0-2+b3: stats1 var, stats2 linreg-ols; beside it datamash 1.7-2.
# Expected: a variance does not depend on the mean, and a straight line has its slope over unix time, too.
# Seen:     both come from sums of squares. The variance of values 0.01 above and below 1e5 is seven times too small,
#           and from 1e7 on it is 0. A line of slope 3 gets -0.019 over unix time. datamash is right.
# Matters:  the noise of large raw counts, or of a pressure in pascal, vanishes in silence, and a drift fitted over unix
#           time is a random number. Subtract the first value before.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian miller=6.6.0-2+b3 datamash=1.7-2
noisy() {
  awk -v mean="$1" 'BEGIN { print "x"; while (n++ < 1000) printf "%.2f\n", mean + (n % 2 ? 0.01 : -0.01) }'
}
line() { awk -v from="$1" 'BEGIN { print "t,x"; while (n < 6) { print from + n "," 3 * n; n++ } }'; }
stated 'mean 0: variance 1.001e-04, datamash 1.001e-04
mean 100000: variance 1.369e-05, datamash 1.001e-04
mean 10000000: variance 0.000e+00, datamash 1.001e-04
from 0: slope 3.000
from 1700000000: slope -0.019' "$(
  for mean in 0 100000 10000000; do
    printf 'mean %d: variance %.3e, datamash %.3e\n' "$mean" "$(noisy "$mean" | mlr --icsv --onidx stats1 -a var -f x)" \
      "$(noisy "$mean" | LC_ALL=C datamash -H svar 1 | tail -1)"
  done
  for from in 0 1700000000; do
    line "$from" | mlr --icsv --onidx stats2 -a linreg-ols -f t,x | cut -d ' ' -f 1 |
      xargs printf 'from %d: slope %.3f\n' "$from"
  done
)"
