#!/usr/bin/env bash
# Package:  Debian 12 qalc 4.5.1-1 (libqalculate).
# Expected: 0.5 °C/min is 0.00833 K/s: in a rate or a coefficient, a degree Celsius is a difference of 1 K.
# Seen:     the offset of the scale goes along: 0.5 °C/min becomes (0.5 + 273.15) K/min, 4.56 K/s. A coefficient per
#           °C is divided by 274.15. 30 °C - 25 °C is 5 °C. GNU units and udunits2 give 0.00833.
# Matters:  rate ramps and sensitivities to temperature, (°/h)/°C and °C/min, are what a gyro's data sheet states. The
#           result has the right unit; nothing tells that it is off by a factor of 547 or 274.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian qalc=4.5.1-1
export LC_ALL=C.UTF-8 HOME=$PWD
stated '4.560833333 K/s
0.003647638154°/(K·h)
5 °C' "$(qalc -t '0.5 °C/min to K/s'; qalc -t '1 (deg/h)/celsius to (deg/h)/K'; qalc -t '30 °C - 25 °C')"
