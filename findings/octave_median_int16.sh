#!/usr/bin/env bash
# Package:  Debian 12 octave 7.3.0-2: median() of int16, int32 or uint8 data.
# Expected: the median of an even number of equal counts is that count.
# Seen:     the two middle values are added in their own type, which saturates, and the sum is halved: the median of
#           20000 and 20000 is 16384. An odd number of samples is right, and so is mean(), which sums in double.
# Matters:  the median of raw counts is the usual robust bias of a soak. Above half of full scale it sticks at
#           16384 for every even number of samples, without a warning; double(counts) first is right.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian octave=7.3.0-2
cat >counts.m <<'M'
printf("2 x 20000: %d\n", median(int16([20000 20000])));
printf("3 x 20000: %d\n", median(int16([20000 20000 20000])));
printf("20000 ... 20003: %d, as double %.1f\n", median(int16(20000:20003)), median(20000:20003));
printf("2 x -20000: %d\n", median(int16([-20000 -20000])));
printf("int32, 2 x 2e9: %d\n", median(int32([2e9 2e9])));
printf("mean of 2 x 20000: %g\n", mean(int16([20000 20000])));
M
stated '2 x 20000: 16384
3 x 20000: 20000
20000 ... 20003: 16384, as double 20001.5
2 x -20000: -16384
int32, 2 x 2e9: 1073741824
mean of 2 x 20000: 20000' "$(octave-cli --no-history -q counts.m)"
