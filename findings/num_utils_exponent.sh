#!/usr/bin/env bash
# Package:  Debian 12 num-utils 0.5-15: numsum, numaverage.
# Expected: 1e-3 is 0.001, or an error.
# Seen:     the exponent is cut off without a word: 1e-3 counts as 1, and 1.5e-05 as 1.5. The exit code is 0.
# Matters:  most tools write a small rate in rad/s as 4.8e-06. Its mean is then 4.8, while the mean of larger rates of
#           the same column is right.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian num-utils=0.5-15
stated 'sum of 0.001 0.002: 0.003
sum of 1e-3 2e-3: 3
mean of 1.5e-05 1.5e-05: 1.5' "$(
  echo "sum of 0.001 0.002: $(printf '%s\n' 0.001 0.002 | numsum)"
  echo "sum of 1e-3 2e-3: $(printf '%s\n' 1e-3 2e-3 | numsum)"
  echo "mean of 1.5e-05 1.5e-05: $(printf '%s\n' 1.5e-05 1.5e-05 | numaverage)"
)"
