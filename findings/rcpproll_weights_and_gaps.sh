#!/usr/bin/env bash
# Package:  Debian 12 r-cran-rcpproll 0.3.0-2 (R 4.2.2): the arguments weights and na.rm.
# Expected: of a constant rate of 5 every weighted mean, minimum and maximum is 5, and every variance 0, gap or no gap.
#           The median of 3 and 4 beside a gap is 3.5.
# Seen:     the samples are multiplied by the weights first: with weights 1 2 1 the variance of a constant is 4.69, its
#           minimum 3.75, its maximum 7.5. A gap takes no weight with it: the mean of a constant is 3.75 or 5.625.
#           With na.rm = TRUE the median is NA, or off, where a gap is in the window. Without weights the mean, the
#           variance and the limits are right.
# Matters:  a smoothed rate steps by up to a quarter of itself at each dropout, and a spike detector by rolling median
#           is off, or blind, beside it.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian r-base-core=4.2.2.20221110-2 r-cran-rcpproll=0.3.0-2
cat >roll.R <<'R'
library(RcppRoll)
constant <- rep(5, 4)
for (name in c("mean", "var", "min", "max"))
  cat("weighted", name, getExportedValue("RcppRoll", paste0("roll_", name))(constant, weights = c(1, 2, 1)), "\n")
gap <- c(5, NA, 5, 5, 5)
cat("gap, mean", roll_mean(gap, 3, na.rm = TRUE), "\n")
cat("gap, weighted mean", roll_mean(gap, weights = c(1, 2, 1), na.rm = TRUE), "\n")
series <- c(1, NA, 3, 4, 5)
cat("gap, median", roll_median(series, 3, na.rm = TRUE), "\n")
cat("one by one ", sapply(1:3, function(first) median(series[first:(first + 2)], na.rm = TRUE)), "\n")
R
stated 'weighted mean 5 5
weighted var 4.6875 4.6875
weighted min 3.75 3.75
weighted max 7.5 7.5
gap, mean 5 5 5
gap, weighted mean 3.75 5.625 5
gap, median NA 3 4
one by one  2 3.5 4' "$(Rscript --vanilla roll.R 2>&1 | sed 's/ *$//')"
