#!/usr/bin/env bash
# Package:  Debian 12 r-cran-pracma 2.4.2-1 (R 4.2.2): savgol(), beside sgolayfilt() of octave-signal 1.4.3-1.
# Expected: a Savitzky-Golay filter keeps a constant, and any polynomial up to its order, from the first sample on. The
#           first derivative of a rising series is positive.
# Seen:     both ends are continued with zeros: of a constant 1000 the first sample is 604, the fifth 1084. The
#           derivative of a slope of 3 begins with 138. The manual says nothing of it. Octave's sgolayfilt() is right.
# Matters:  half a window at each end is pulled to 0 and rings. A temperature of 20 degrees starts at 12, and its rate,
#           a regressor of the thermal model, starts at one that never was.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian r-base-core=4.2.2.20221110-2 r-cran-pracma=2.4.2-1 octave=7.3.0-2 octave-signal=1.4.3-1
cat >ends.R <<'R'
library(pracma)
show <- function(name, values) cat(name, sprintf("%.1f", values[1:6]), "\n")
show("savgol, constant:  ", savgol(rep(1000, 30), 11, 2))
show("savgol, derivative:", savgol(1000 + 3 * (0:29), 11, 2, 1))
R
cat >ends.m <<'M'
pkg load signal
printf("sgolayfilt, constant:   %s\n", sprintf("%.1f ", sgolayfilt(1000 * ones(30, 1), 2, 11)(1:6)));
printf("sgolayfilt, derivative: %s\n", sprintf("%.1f ", sgolayfilt(1000 + 3 * (0:29)', 2, 11, 1)(1:6)));
M
stated 'savgol, constant:   603.7 799.5 960.4 1062.9 1083.9 1000.0
savgol, derivative: 137.9 129.2 111.4 84.4 48.3 3.0
sgolayfilt, constant:   1000.0 1000.0 1000.0 1000.0 1000.0 1000.0
sgolayfilt, derivative: 3.0 3.0 3.0 3.0 3.0 3.0' "$(
  Rscript --vanilla ends.R 2>&1 | sed 's/ *$//'
  octave-cli --no-history -q ends.m 2>&1 | sed 's/ *$//'
)"
