#!/usr/bin/env bash
# Package:  Debian 12 r-cran-waveslim 1.8.4-1 (R 4.2.2): wave.variance(), argument type.
# Expected: the five types give 95 % limits of the wavelet variance (twice of it, by Haar, is the Allan variance). For
#           512 samples of white noise these are about 0.43 and 0.57 at the first level.
# Seen:     "eta1" and "eta2" return a lone 0, without the variance. "gaussian" gives NA limits after brick.wall(), as
#           the manual's own example calls it. "nongaussian" gives widths that follow nothing: limits of +-56 % at the
#           first level and +-1 % at the second. "eta3", the default, is right.
# Matters:  the limits decide whether a bias instability is told from white noise, and for which averaging times.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian r-base-core=4.2.2.20221110-2 r-cran-waveslim=1.8.4-1
cat >limits.R <<'R'
suppressMessages(library(waveslim))
set.seed(1)
levels <- brick.wall(modwt(rnorm(512), "haar", 2), "haar")
for (type in c("eta1", "eta2", "eta3", "gaussian", "nongaussian")) {
  found <- wave.variance(levels, type = type)
  cat(type, if (is.null(dim(found))) format(found) else
    sprintf("%.2f [%.2f, %.2f]", found[1:2, 1], found[1:2, 2], found[1:2, 3]), "\n")
}
R
stated 'eta1 0
eta2 0
eta3 0.53 [0.45, 0.63] 0.26 [0.21, 0.34]
gaussian 0.53 [NA, NA] 0.26 [NA, NA]
nongaussian 0.53 [0.23, 0.82] 0.26 [0.26, 0.26]' "$(Rscript --vanilla limits.R 2>&1 | sed 's/ *$//')"
