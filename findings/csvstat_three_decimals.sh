#!/usr/bin/env bash
# Package:  Debian 12 csvkit 1.0.7-1: csvstat.
# Expected: mean, minimum and standard deviation of rates near 5e-6 rad/s, to a few significant digits.
# Seen:     all numbers are rounded to three decimals: mean 0, minimum -0, standard deviation 0. So is unix time, to a
#           millisecond. This version has no option for more.
# Matters:  1 °/h is 4.8e-6 rad/s. A live channel looks dead, exactly 0 with no noise, and a check built on
#           `csvstat --mean` passes for every bias.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian csvkit=1.0.7-1
printf '%s\n' time,rate 1700000000.123456,0.0000048 1700000000.124456,-0.0000031 1700000000.125456,0.0000020 >run.csv
stated 'rate: 0 -0 0
time: 1700000000.123' "$(
  echo "rate: $(for figure in --mean --min --stdev; do csvstat "$figure" -c rate run.csv; done | xargs)"
  echo "time: $(csvstat --min -c time run.csv)"
)"
