#!/usr/bin/env bash
# Package:  Debian 12 octave-signal 1.4.3-1 (octave 7.3.0-2): zp2sos() of butter(), cheby1() and ellip() filters.
# Expected: a filter of order 4 becomes two sections of order 2. Run by sosfilt(), they settle where filter() does.
# Seen:     only one real zero goes into a section. A Butterworth low pass of order 4 gets four sections, and two of
#           them have denominators that begin with 0. sosfilt() divides by it: NaN from the first sample on. Every
#           filter of butter() and cheby1() is hit, and odd orders of ellip(). Even ones, without real zeros, are right.
# Matters:  a filter on a board, and any low pass of high order, is run in sections. Coefficients taken from here divide
#           by 0 there, and a section with 0 in front delays by a sample.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian octave=7.3.0-2 octave-signal=1.4.3-1
cat >sections.m <<'M'
pkg load signal
function settled(name, z, p, k)
  [sections, gain] = zp2sos(z, p, k);
  [b, a] = zp2tf(z, p, k);
  printf("%s: %d sections, filter %.3f, sosfilt %.3f\n", name, rows(sections), filter(b, a, ones(2000, 1))(end),
         gain * sosfilt(sections, ones(2000, 1))(end));
end
[z, p, k] = butter(4, 0.1);
settled("butter 4", z, p, k);
[sections, ~] = zp2sos(z, p, k);
printf("its first denominator:%s, its last:%s\n", sprintf(" %.2f", sections(1, 4:6)),
       sprintf(" %.2f", sections(4, 4:6)));
[z, p, k] = butter(1, 0.1);
settled("butter 1", z, p, k);
[z, p, k] = cheby1(4, 1, 0.1);
settled("cheby1 4", z, p, k);
[z, p, k] = ellip(3, 1, 40, 0.1);
settled("ellip 3", z, p, k);
[z, p, k] = ellip(4, 1, 40, 0.1);
settled("ellip 4", z, p, k);
M
stated 'butter 4: 4 sections, filter 1.000, sosfilt NaN
its first denominator: 1.00 -1.48 0.56, its last: 0.00 0.00 1.00
butter 1: 1 sections, filter 1.000, sosfilt NaN
cheby1 4: 4 sections, filter 0.891, sosfilt NaN
ellip 3: 2 sections, filter 1.000, sosfilt NaN
ellip 4: 2 sections, filter 0.891, sosfilt 0.891' "$(octave-cli --no-history -q sections.m 2>&1)"
