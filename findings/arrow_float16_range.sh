#!/usr/bin/env bash
# Package:  npm apache-arrow 21.2.0: vectors of Float16, made of numbers.
# Expected: what is too large for a half float becomes infinity, and what is too small becomes 0.
# Seen:     from 65536 on only the fraction is left: 1e5 is 3.05, and 720000 is 2.75. Below 1.5e-8 (2^-26) numbers lose
#           their meaning: 1e-8 is minus infinity, 5e-9 is NaN, 1e-9 is 4.2e-5. Nothing is thrown. What lies between
#           is right, 65520 is infinity, as it should be, and 0 is 0.
# Matters:  a rate in degree/hour passes 65536 at 18.2 degree/s, and looks like that of a board at rest. In rad/s the
#           earth's rate is right, and a residual of 0.001 degree/hour, 5e-9, takes every mean to NaN.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
npm_packages apache-arrow@21.2.0
cat >half.mjs <<'J'
import { Float16, vectorFromArray } from 'apache-arrow';
const show = (...values) => {
  const read = [...vectorFromArray(values, new Float16())].map((value) => value.toPrecision(3));
  console.log(values.map((value, index) => `${value}: ${read[index]}`).join(', '));
};
show(0.5, 1000, 65504, 65520, 7.29e-5, 0);
show(65536, 1e5, -1e5, 720000);
show(2e-8, 1e-8, 5e-9, 1e-9, -1e-9);
J
stated '0.5: 0.500, 1000: 1.00e+3, 65504: 6.55e+4, 65520: Infinity, 0.0000729: 0.0000729, 0: 0.00
65536: 2.00, 100000: 3.05, -100000: -3.05, 720000: 2.75
2e-8: 0.00, 1e-8: -Infinity, 5e-9: NaN, 1e-9: 0.0000420, -1e-9: -0.0000420' "$(node half.mjs)"
