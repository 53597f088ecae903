#!/usr/bin/env bash
# Package:  Debian 12 python3-numpy 1:1.24.2-1+deb12u1: numpy.unwrap() with period=65536.
# Expected: a 16-bit counter (dtype uint16) becomes a steadily growing one; `period` is there for integers.
# Seen:     the array comes back as it was: 65536 is added in uint16, where it is 0. Neither an error nor a warning.
#           With int64 data the same call is right.
# Matters:  sequence numbers and angle increments of gyros wrap at 16 bits, and np.frombuffer() gives them as uint16.
#           Gaps found, or rates summed, from such a counter are wrong at each wrap.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian python3-numpy=1:1.24.2-1+deb12u1
cat >counter.py <<'P'
import numpy as np
counter = np.array([50000, 60000, 4464, 14464], dtype=np.uint16)
print("uint16", np.unwrap(counter, period=65536).tolist())
print("int64 ", np.unwrap(counter.astype(np.int64), period=65536).tolist())
P
stated 'uint16 [50000, 60000, 4464, 14464]
int64  [50000, 60000, 70000, 80000]' "$(/usr/bin/python3 counter.py)"
