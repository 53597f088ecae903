#!/usr/bin/env bash
# Package:  Debian 12 datamash 1.7-2: operation bin.
# Expected: a value at the edge of a bin belongs to the bin that begins there, whatever its sign: -10 in bins of 10 is
#           -10, as 10 is 10.
# Seen:     an exact negative multiple falls one bin lower: -10 to -20, -20 to -30. -10 and -19.9 share a bin; -9.9
#           does not.
# Matters:  temperatures of whole degrees, and set points of a chamber (-20, -10, 0), are exact multiples. A table of
#           mean drift by temperature is one bin off below zero alone.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian datamash=1.7-2
stated '-20 -30
-19.9 -20
-10 -20
-9.9 -10
0 0
10 10
19.9 10
20 20' "$(printf '%s\n' -20 -19.9 -10 -9.9 0 10 19.9 20 | LC_ALL=C datamash --full -t ' ' bin:10 1)"
