#!/usr/bin/env bash
# Package:  npm moving-averages 4.0.6: ma(), ema(), wma().
# Expected: a sample that is missing (null, NaN) makes the averages over it missing, or those of the samples there are.
# Seen:     ma() and wma() take it for 0 and divide by the whole window: a constant rate of 10 becomes 6.67, or 5 to 8.3,
#           as long as the gap is in the window. ema() leaves it out. Nothing is said in either case.
# Matters:  each lost sample of a constant drift makes a dip of a third, which looks like an event of the gyro.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
npm_packages moving-averages@4.0.6
cat >gap.cjs <<'J'
const averages = require('moving-averages');
for (const missing of [null, NaN]) {
  const rate = [10, 10, 10, missing, 10, 10, 10];
  for (const kind of ['ma', 'wma', 'ema']) {
    const shown = Array.from(averages[kind](rate, 3), (value) => (value === undefined ? '-' : +value.toFixed(2)));
    console.log(`${kind} beside ${missing}:`, shown.join(' '));
  }
}
J
stated 'ma beside null: - - 10 6.67 6.67 6.67 10
wma beside null: - - 10 5 6.67 8.33 10
ema beside null: 10 10 10 10 10 10 10
ma beside NaN: - - 10 6.67 6.67 6.67 10
wma beside NaN: - - 10 5 6.67 8.33 10
ema beside NaN: 10 10 10 10 10 10 10' "$(node gap.cjs)"
