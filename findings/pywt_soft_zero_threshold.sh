#!/usr/bin/env bash
# Package:  Debian 12 python3-pywt 1.1.1-3+b2: pywt.threshold() with a threshold of 0.
# Expected: a threshold of 0 leaves the coefficients alone, in every mode.
# Seen:     soft and garrote turn each coefficient that is 0 into NaN (0/0). hard leaves it alone.
# Matters:  the usual threshold is median(|detail|)/0.6745 times sqrt(2 ln n). For a quantized gyro at rest more than
#           half of the details are exactly 0, so the threshold is 0 too, and the denoised rate is NaN throughout.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian python3-pywt=1.1.1-3+b2
cat >quantized.py <<'P'
import warnings
import numpy as np
import pywt
warnings.simplefilter("ignore")
counts = np.zeros(256)
counts[100:110] = 1
details = pywt.wavedec(counts, "sym8", level=3)
threshold = np.median(np.abs(details[-1])) / 0.6745 * np.sqrt(2 * np.log(256))
print("threshold", threshold)
for mode in ("soft", "garrote", "hard"):
    kept = [details[0]] + [pywt.threshold(d, threshold, mode) for d in details[1:]]
    print(mode, "NaN in the denoised rate:", bool(np.isnan(pywt.waverec(kept, "sym8")).any()))
P
stated 'threshold 0.0
soft NaN in the denoised rate: True
garrote NaN in the denoised rate: True
hard NaN in the denoised rate: False' "$(/usr/bin/python3 quantized.py)"
