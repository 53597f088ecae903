#!/usr/bin/env bash
# Package:  Debian 12 r-base-core 4.2.2.20221110-2: lowess(); npm @stdlib/stats-lowess 0.2.2, the same algorithm.
# Expected: a smoother made of local lines keeps a line, to its last point.
# Seen:     the end of an even ramp may stand still. Of 20, 21 ... 119, with f = 0.2, the last is 101, in both. In steps
#           of 0.8 the last is 88 instead of 99.2; in steps of 0.9 all is right. The residuals are 0 but for rounding.
#           The robustness weights made of them are 0 where rounding wills it, and a window without weights repeats
#           the value before. iter = 0 (nsteps: 0) is right.
# Matters:  a chamber's programme and a simulated temperature are such ramps. The smoothed end is late by a window, and
#           its rate of change is 0.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian r-base-core=4.2.2.20221110-2
npm_packages @stdlib/stats-lowess@0.2.2
cat >ramp.R <<'R'
show <- function(name, count, slope, ...) {
  x <- 0:(count - 1)
  smooth <- lowess(x, 20 + slope * x, ...)$y
  still <- sum(abs(diff(smooth)) < slope / 2)
  cat("R,", name, "ends with", tail(round(smooth, 6), 1), "after", still, "still steps\n")
}
show("20 to 119", 100, 1, f = 0.2)
show("20 to 99.2", 100, 0.8, f = 0.2)
show("20 to 109.1", 100, 0.9, f = 0.2)
show("20 to 119, iter 0", 100, 1, f = 0.2, iter = 0)
R
cat >ramp.cjs <<'J'
const lowess = require('@stdlib/stats-lowess');
function show(name, count, slope, options) {
  const x = Array.from({ length: count }, (_, i) => i);
  const { y } = lowess(x, x.map((i) => 20 + slope * i), options);
  const still = y.filter((value, i) => i > 0 && value - y[i - 1] < slope / 2).length;
  console.log(`@stdlib, ${name} ends with ${+y.at(-1).toFixed(6)} after ${still} still steps`);
}
show('20 to 119', 100, 1, { f: 0.2 });
show('20 to 119, nsteps 0', 100, 1, { f: 0.2, nsteps: 0 });
J
stated 'R, 20 to 119 ends with 101 after 9 still steps
R, 20 to 99.2 ends with 88 after 10 still steps
R, 20 to 109.1 ends with 109.1 after 0 still steps
R, 20 to 119, iter 0 ends with 119 after 0 still steps
@stdlib, 20 to 119 ends with 101 after 10 still steps
@stdlib, 20 to 119, nsteps 0 ends with 119 after 0 still steps' "$(
  Rscript --vanilla ramp.R 2>&1
  node ramp.cjs
)"
