#!/usr/bin/env bash
# Package:  Debian 12 cdo 2.1.1-1+deb12u1: timmean, timstd and runmean of 16-bit counts.
# Expected: a mean and a standard deviation are floating-point numbers, whatever the type of what they are made of.
# Seen:     they are written in the type of the input: the mean of 10, 11, 11, 11 is 11, their standard deviation
#           0, a running mean of 10 and 11 is 11. With -b F32 they are right.
# Matters:  counts of a gyro are stored as short. What is averaged is a drift of fractions of a count, and the noise
#           about it is below one: both are gone, without a warning.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian cdo=2.1.1-1+deb12u1 netcdf-bin=1:4.9.0-3+b1
cat >counts.cdl <<'CDL'
netcdf counts {
dimensions: time = UNLIMITED;
variables: double time(time); time:units = "seconds since 2026-01-01"; short counts(time);
data: time = 0, 1, 2, 3; counts = 10, 11, 11, 11;
}
CDL
ncgen -o counts.nc counts.cdl
of() {
  cdo -s "$@" counts.nc made.nc
  echo "$*: $(ncdump -v counts made.nc | tr -d '\n' | sed 's/.* counts = \([^;]*\) ;.*/\1/')"
}
stated 'timmean: 11
timstd: 0
runmean,2: 11, 11, 11
-b F32 timmean: 10.75
-b F32 timstd: 0.4330127
-b F32 runmean,2: 10.5, 11, 11' "$(
  of timmean
  of timstd
  of runmean,2
  of -b F32 timmean
  of -b F32 timstd
  of -b F32 runmean,2
)"
