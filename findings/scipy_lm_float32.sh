#!/usr/bin/env bash
# Package:  Debian 12 python3-scipy 1.10.1-2 and python3-numpy 1:1.24.2-1+deb12u1: least_squares(method="lm").
# Expected: a straight line fitted to float32 columns by float64 parameters is found, as with method="trf".
# Seen:     success is True ("gtol" satisfied) far from the minimum. The residuals are float32, since NumPy keeps the
#           type of the array; the step of MINPACK's numerical derivative (1.5e-8) then drowns in their rounding.
# Matters:  ULog, MAT and HDF5 recordings come as float32. A drift polynomial in temperature fitted this way is wrong,
#           and neither a warning nor the status says so. float64 columns are right.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian python3-numpy=1:1.24.2-1+deb12u1 python3-scipy=1.10.1-2
cat >line.py <<'P'
import numpy as np
from scipy.optimize import least_squares
temperature = np.linspace(-20, 60, 500)
rate = 0.02 * temperature + 3
for kind in ("float32", "float64"):
    t, r = temperature.astype(kind), rate.astype(kind)
    for method in ("lm", "trf"):
        fit = least_squares(lambda p: p[0] * t + p[1] - r, [0.0, 0.0], method=method)
        found = np.allclose(fit.x, [0.02, 3], rtol=1e-3)
        print(kind, method, "success", fit.success, "line", "found" if found else "missed")
P
stated 'float32 lm success True line missed
float32 trf success True line found
float64 lm success True line found
float64 trf success True line found' "$(/usr/bin/python3 line.py)"
