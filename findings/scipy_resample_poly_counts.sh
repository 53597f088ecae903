#!/usr/bin/env bash
# Package:  Debian 12 python3-scipy 1.10.1-2: scipy.signal.resample_poly() of an integer array.
# Expected: raw counts resampled from 1 kHz to 200 Hz keep their mean, or the integer type is refused.
# Seen:     every output is 0, of a floating type and without a warning. The filter's taps, all below 1, are converted
#           to the type of the data. The same counts as float64 are right.
# Matters:  raw counts are int16 or int32. Whoever resamples them this way gets a gyro that is perfectly at rest.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian python3-scipy=1.10.1-2
cat >counts.py <<'P'
import numpy as np
from scipy.signal import resample_poly
counts = 1000 + (np.arange(500) % 3)
for kind in ("int16", "int32", "float64"):
    resampled = resample_poly(counts.astype(kind), 1, 5)
    print(kind, "to", resampled.dtype, "mean of the middle %.0f" % resampled[40:60].mean())
P
stated 'int16 to float32 mean of the middle 0
int32 to float64 mean of the middle 0
float64 to float64 mean of the middle 1001' "$(/usr/bin/python3 counts.py)"
