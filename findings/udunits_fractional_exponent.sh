#!/usr/bin/env bash
# Package:  Debian 12 udunits-bin 2.2.28-5 (and libudunits2-0, behind NCO, CDO and the R package units).
# Expected: degree/hour^0.5, the unit of the angle random walk, is understood, or refused: exponents are integers.
# Seen:     it is 5 degrees. The exponent ends before the point, the point is a multiplication sign, and 5 is a factor:
#           degree / hour^0 . 5. hour^1.5 is read as hour and a factor of 5. In brackets the factor is 1/5, and hour0.5
#           is a factor 0.5. hour^(1/2), hour^.5 and sqrt(hour) are refused.
# Matters:  a random walk of 0.01 degree/hour^0.5 in a units attribute becomes an angle of 0.05 degrees without a word,
#           and the check that a unit is an angle passes. State the square: degree^2/hour.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian udunits-bin=2.2.28-5
convert() { udunits2 -A -H "$1" -W "$2" 2>&1 | sed -n '/[^ ]/{s/^ *//;p;q}'; }
stated '1 degree/hour^0.5 = 5 degree
1 degree/hour^1.5 = 5 degree/hour
1 degree/(hour^0.5) = 0.2 degree
1 degree/hour0.5 = 0.5 degree
udunits2: Don'"'"'t recognize "degree/hour^(1/2)"
1 degree^2/hour = 0.000277778 degree^2/s' "$(
  convert 'degree/hour^0.5' degree
  convert 'degree/hour^1.5' degree/hour
  convert 'degree/(hour^0.5)' degree
  convert 'degree/hour0.5' degree
  convert 'degree/hour^(1/2)' degree
  convert 'degree^2/hour' 'degree^2/s'
)"
