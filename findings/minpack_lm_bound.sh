#!/usr/bin/env bash
# Package:  Debian 12 r-cran-minpack.lm 1.2-3-1 (R 4.2.2): nlsLM() with lower bounds.
# Expected: where a bound holds one coefficient, the other is at the minimum that is left: for intercept >= 5 the slope
#           is 2.5235, as nls(algorithm = "port") finds. Bounds with names belong to the coefficients of these names.
# Seen:     the slope is 2.63 or 2.6376, by its starting value, with 13 or 15 % more residual. isConv is TRUE. Names of
#           bounds are ignored, by nls() as well: the order counts.
# Matters:  a time constant or a scale kept positive by a bound spoils all other coefficients as soon as it gets there,
#           although the fit says it converged. Fix the coefficient at the bound and fit the others again.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian r-base-core=4.2.2.20221110-2 r-cran-minpack.lm=1.2-3-1
cat >bound.R <<'R'
library(minpack.lm)
run <- data.frame(t = 0:9, rate = 2 + 3 * (0:9) + c(1, -1, 2, 0, -2, 1, 0, -1, 1, -1) / 10)
show <- function(name, fit)
  cat(sprintf("%s: %.4f + %.4f t, residual %.2f\n", name, coef(fit)[1], coef(fit)[2], deviance(fit)))
for (slope in c(0, 1)) {
  fit <- nlsLM(rate ~ a + b * t, run, start = list(a = 6, b = slope), lower = c(5, -10))
  show(sprintf("nlsLM from slope %d, converged %s", slope, fit$convInfo$isConv), fit)
}
start <- list(a = 6, b = 6)
show("nls port", nls(rate ~ a + b * t, run, start = start, lower = c(5, -10), algorithm = "port"))
show("nls port, a >= -10 and b >= 5 by name",
     nls(rate ~ a + b * t, run, start = start, lower = c(b = 5, a = -10), algorithm = "port"))
R
stated 'nlsLM from slope 0, converged TRUE: 5.0000 + 2.6376 t, residual 29.14
nlsLM from slope 1, converged TRUE: 5.0000 + 2.6300 t, residual 28.67
nls port: 5.0000 + 2.5235 t, residual 25.43
nls port, a >= -10 and b >= 5 by name: 5.0000 + 2.5235 t, residual 25.43' "$(Rscript --vanilla bound.R 2>&1)"
