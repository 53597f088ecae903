#!/usr/bin/env bash
# Package:  Debian 12 octave 7.3.0-2: mean(); python3-bottleneck 1.3.5+ds1-2+b1: nanmean(); python3-numexpr 2.8.4-1+b2:
#           sum(). Beside them python3-numpy 1:1.24.2-1+deb12u1: mean().
# Expected: the mean of ten million times 25.3 in single precision is 25.3, to the five digits that NumPy gives.
# Seen:     all three add one by one in single precision: 27.80, off by a tenth. Octave's std() of the constant is 2.6;
#           sum(x, "double") is right.
# Matters:  ten million samples are three hours at 1 kHz, and loggers store single precision. A mean temperature or bias
#           is wrong by 10 %, and the longer the recording the worse.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian octave=7.3.0-2 python3-bottleneck=1.3.5+ds1-2+b1 python3-numexpr=2.8.4-1+b2 python3-numpy=1:1.24.2-1+deb12u1
cat >single_mean.m <<'M'
x = single(25.3) * ones(1, 1e7, "single");
printf("Octave: mean %.2f, std %.1f, double %.2f\n", mean(x), std(x), sum(x, "double") / 1e7);
M
cat >single_mean.py <<'P'
import bottleneck, numexpr
import numpy as np
x = np.full(10_000_000, 25.3, np.float32)
total = numexpr.evaluate("sum(x)")
print("Bottleneck: %.2f, numexpr: %.2f, NumPy: %.2f" % (bottleneck.nanmean(x), total / len(x), x.mean()))
P
stated 'Octave: mean 27.80, std 2.6, double 25.30
Bottleneck: 27.80, numexpr: 27.80, NumPy: 25.30' \
  "$(octave-cli --no-history -q single_mean.m; /usr/bin/python3 single_mean.py)"
