#!/usr/bin/env bash
# Package:  Debian 12 octave 7.3.0-2: idivide() of signed integers.
# Expected: "fix", the default, rounds the quotient towards zero, as its help says and as / does in C: -7/2 = -3.
# Seen:     with a negative dividend it rounds away from zero wherever there is a remainder: -7/2 = -4, -1/8 = -1,
#           -7/-2 = 4. Positive dividends and exact quotients are right.
# Matters:  golden vectors of fixed-point firmware are often made in Octave. The quotient of a negative count is one
#           LSB off from the C code's, for negative rates alone: a bias that depends on the sign of the rate.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian octave=7.3.0-2
cat >quotients.m <<'M'
for pair = {[7 2], [-7 2], [-7 -2], [-1 8], [-100 8], [-8 2]}
  dividend = pair{1}(1);
  divisor = pair{1}(2);
  printf("%d / %d: %d, towards zero %d\n", dividend, divisor, idivide(int32(dividend), int32(divisor), "fix"),
         fix(dividend / divisor));
end
M
stated '7 / 2: 3, towards zero 3
-7 / 2: -4, towards zero -3
-7 / -2: 4, towards zero 3
-1 / 8: -1, towards zero 0
-100 / 8: -13, towards zero -12
-8 / 2: -4, towards zero -4' "$(octave-cli --no-history -q quotients.m)"
