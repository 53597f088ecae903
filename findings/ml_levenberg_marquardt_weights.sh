#!/usr/bin/env bash
# Package:  npm ml-levenberg-marquardt 5.1.0: the option weights.
# Expected: one weight for all points changes nothing: a line through exact points has its slope and intercept.
# Seen:     weight 1 finds 2 and 3. With weight 10 or 100 the initial values come back untouched after all 100
#           iterations, with weight 0.1 they have hardly moved. Nothing is thrown, and damping does not help.
# Matters:  a weight is 1/sigma: rates with 0.1 °/h of noise have weight 10. The "fitted" temperature coefficients are
#           then the guess they started from. Look at parameterError, or scale the weights to about 1.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
npm_packages ml-levenberg-marquardt@5.1.0
cat >line.mjs <<'J'
import { levenbergMarquardt } from 'ml-levenberg-marquardt';
const x = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9];
const data = { x, y: x.map((t) => 2 + 3 * t) };
const line = ([intercept, slope]) => (t) => intercept + slope * t;
for (const weights of [1, 0.1, 10, 100]) {
  const fit = levenbergMarquardt(data, line, { initialValues: [1, 1], weights });
  console.log(`weight ${weights}:`, fit.parameterValues.map((value) => value.toFixed(2)).join(' '));
}
J
stated 'weight 1: 2.00 3.00
weight 0.1: 1.01 1.02
weight 10: 1.00 1.00
weight 100: 1.00 1.00' "$(node line.mjs)"
