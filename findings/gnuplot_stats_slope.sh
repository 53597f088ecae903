#!/usr/bin/env bash
# Package:  Debian 12 gnuplot-nox 5.4.4+dfsg1-2+b2: the command stats with two columns.
# Expected: an exact line of slope 0.3 has STATS_slope 0.3 and STATS_correlation 1 over unix time, too.
# Seen:     an hour of it gives 0.2987 and 0.9957, ten seconds NaN. Slope and correlation come from sums of squares,
#           although STATS_stddev_x of the same call is right. Less the first stamp all is as expected.
# Matters:  a bias drift read off this way is 0.4 % wrong, or more, and an invented scatter (a correlation below 1)
#           explains it. Shorter recordings at the same date are worse.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian gnuplot-nox=5.4.4+dfsg1-2+b2
slope() {
  awk -v count="$1" -v step="$2" \
    'BEGIN { for (i = 0; i < count; i++) printf "%.2f %.6f\n", 1700000000 + i * step, 5 + 0.3 * i * step }' >line.txt
  gnuplot -e "stats 'line.txt' using (\$1 - $3):2 nooutput;
    print sprintf('%.4f %.4f %.2f', STATS_slope, STATS_correlation, STATS_stddev_x)" 2>&1
}
stated 'an hour: 0.2987 0.9957 1039.23
less the first stamp: 0.3000 1.0000 1039.23
ten seconds: nan nan 2.89' "$(
  echo "an hour: $(slope 3600 1 0)"
  echo "less the first stamp: $(slope 3600 1 1700000000)"
  echo "ten seconds: $(slope 1000 0.01 0)"
)"
