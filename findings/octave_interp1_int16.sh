#!/usr/bin/env bash
# Package:  Debian 12 octave 7.3.0-2: interp1(), linear, of integer values.
# Expected: half way between the counts 0 and 4 is 2, whatever the type of the counts.
# Seen:     the slope is computed in the values' type, rounded to a whole count a unit of x. 4 counts over 10 units
#           give a slope of 0 and a staircase; 5 counts over 10 give a slope of 1 and twice the values, 10 where the
#           next sample is 5. double(counts) works. "cubic" and "pchip" refuse integers.
# Matters:  raw int16 temperature is put on the time base of the gyro this way. Slow drifts become steps, or overshoot
#           and jump back, in the very regressor of the thermal model.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian octave=7.3.0-2
cat >interpolate.m <<'M'
at = 0:2:8;
for next = [4 5]
  printf("0 to %d, int16:  %s\n", next, num2str(interp1([0 10], int16([0 next]), at)));
  printf("0 to %d, double: %s\n", next, num2str(interp1([0 10], [0 next], at)));
end
M
stated '0 to 4, int16:  0  0  0  0  0
0 to 4, double: 0         0.8         1.6         2.4         3.2
0 to 5, int16:  0  2  4  6  8
0 to 5, double: 0  1  2  3  4' "$(octave-cli --no-history -q interpolate.m)"
