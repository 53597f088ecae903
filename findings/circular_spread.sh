#!/usr/bin/env bash
# Package:  Debian 12 r-cran-circular 0.4-95-1 (R 4.2.2): mean(), sd() and others of angles with units = "degrees".
# Expected: of 10, 20 and 30 degrees the mean is 20 degrees, and the standard deviation 8.2 degrees, about.
# Seen:     the mean, the median and the range are in degrees. sd(), angular.deviation(), meandeviation() and
#           dist.circular() are in radians: 0.143. Neither the results nor the manual of sd() name the unit.
# Matters:  headings and rate-table angles are circular. A repeatability of 8 degrees is reported as 0.14 degrees next
#           to a mean in degrees, and a limit in degrees passes.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian r-base-core=4.2.2.20221110-2 r-cran-circular=0.4-95-1
cat >angles.R <<'R'
suppressMessages(library(circular))
angles <- circular(c(10, 20, 30), units = "degrees")
for (name in c("mean", "median", "range", "sd", "angular.deviation", "meandeviation"))
  cat(name, format(as.numeric(do.call(name, list(angles))), digits = 3), "\n")
cat("dist.circular", format(as.numeric(dist.circular(angles[1:2], method = "geodesic")), digits = 3), "\n")
cat("sd, straight,", format(sqrt(mean((c(10, 20, 30) - 20)^2)), digits = 3), "\n")
R
stated 'mean 20
median 20
range 20
sd 0.143
angular.deviation 0.142
meandeviation 0.116
dist.circular 0.175
sd, straight, 8.16' "$(Rscript --vanilla angles.R 2>&1 | sed 's/ *$//')"
