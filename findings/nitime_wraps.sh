#!/usr/bin/env bash
# Package:  Debian 12 python3-nitime 0.9-5 (NumPy 1:1.24.2-1+deb12u1): TimeArray.
# Expected: 5000 hours are 5000 hours, and unix time is a time in seconds.
# Seen:     whatever the unit, time is kept in picoseconds of 64 bits, which last for 106.75 days. 5000 h are -124.1 h,
#           and 1700000000 s are 2899545.2 s, without a word. Times with a fraction are -9223372.04 s, after a warning
#           of NumPy's.
# Matters:  ageing runs are longer, and loggers stamp in unix time. The intervals between the samples stay right, so a
#           spectrum looks well, and nothing fits the stamps of the temperature.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian python3-nitime=0.9-5 python3-numpy=1:1.24.2-1+deb12u1
cat >wrap.py <<'P'
from nitime.timeseries import TimeArray

for time, unit in [(2500, "h"), (5000, "h"), (1700000000, "s"), (1700000000.5, "s")]:
    print(time, unit, "is", TimeArray([time], time_unit=unit))
P
stated "2500 h is TimeArray([2500.], time_unit='h')
5000 h is TimeArray([-124.09557603], time_unit='h')
1700000000 s is TimeArray([2899545.21872125], time_unit='s')
1700000000.5 s is TimeArray([-9223372.03685478], time_unit='s')
RuntimeWarning: invalid value encountered in cast" "$(
  /usr/bin/python3 wrap.py 2>warnings.txt
  grep -o 'RuntimeWarning.*' warnings.txt
)"
