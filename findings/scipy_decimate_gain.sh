#!/usr/bin/env bash
# Package:  Debian 12 python3-scipy 1.10.1-2: scipy.signal.decimate().
# Expected: a constant rate stays what it is: a decimator has a gain of 1 at zero frequency.
# Seen:     1000 becomes 988.6, at every factor and at any length. The default is a Chebyshev filter of order 8 with
#           0.05 dB of ripple, whose gain at zero frequency is the trough of the ripple; it is run forth and back.
#           An odd order, or ftype="fir", keeps the mean.
# Matters:  it takes 1.1 %, 11 000 ppm, off the bias and the scale factor of a gyro. A drift model fitted to decimated
#           data is that much too small for the board, which runs on the full rate.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian python3-scipy=1.10.1-2
cat >constant.py <<'P'
import numpy as np
from scipy.signal import decimate
def middle(**options):
    decimated = decimate(np.full(20000, 1000.0), **options)
    return "%.1f" % decimated[len(decimated) // 2]
print("by 2:", middle(q=2), "by 5:", middle(q=5), "by 10:", middle(q=10))
print("order 7:", middle(q=5, n=7), "fir:", middle(q=5, ftype="fir"))
P
stated 'by 2: 988.6 by 5: 988.6 by 10: 988.6
order 7: 1000.0 fir: 1000.0' "$(/usr/bin/python3 constant.py)"
