#!/usr/bin/env bash
# Package:  Debian 12 dateutils 0.4.10-1: dateutils.ddiff and dateutils.dconv, %N for nanoseconds.
# Expected: from 00:00:00.250 to 00:00:01.750 are 1.5 s.
# Seen:     ddiff gives 1 s, and %N prints nine zeros, even where an input format with %N reads the fraction. dconv
#           drops the fraction unless the input format has %N, and always that of unix time (%s).
# Matters:  %N in the output looks like the resolution. Gaps between samples, and the offset of the clocks of two logs,
#           come in whole seconds, up to one second off.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian dateutils=0.4.10-1
from=2026-01-01T00:00:00.250
to=2026-01-01T00:00:01.750
read_fraction=(-i '%Y-%m-%dT%H:%M:%S.%N')
stated 'difference 1.000000000
with %N 1.000000000
converted 01.000000000
with %N 01.750000000
unix time 20.000000000' "$(
  echo "difference $(dateutils.ddiff -f %S.%N "$from" "$to")"
  echo "with %N $(dateutils.ddiff "${read_fraction[@]}" -f %S.%N "$from" "$to")"
  echo "converted $(dateutils.dconv -f %S.%N "$to")"
  echo "with %N $(dateutils.dconv "${read_fraction[@]}" -f %S.%N "$to")"
  echo "unix time $(dateutils.dconv -i %s -f %S.%N 1700000000.75)"
)"
