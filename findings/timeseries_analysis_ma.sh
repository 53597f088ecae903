#!/usr/bin/env bash
# Package:  npm timeseries-analysis 1.0.12: ma() and lwma().
# Expected: the moving average of a rising series rises: over three samples 2, 3, 4 ... for 1, 2, 3, 4 ..., with the first
#           two left out or averaged over fewer samples.
# Seen:     the first three samples stay as they are, and the average of three samples stands at the one after them:
#           1 2 3 2 3 4 5. It falls at the fourth. lwma() falls from 3 to 1.67 there, as its weights are largest for the
#           oldest sample.
# Matters:  a temperature smoothed so begins with a step back by half the window and then lags by (window + 1) / 2 samples
#           instead of (window - 1) / 2. Its rate, a regressor of the thermal model, has a spike at each start.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
npm_packages timeseries-analysis@1.0.12
cat >ramp.cjs <<'J'
const timeseries = require('timeseries-analysis');
for (const [kind, period] of [['ma', 3], ['ma', 5], ['lwma', 3]]) {
  const series = new timeseries.main(Array.from({ length: 10 }, (_, i) => [i, i + 1]));
  series[kind]({ period });
  console.log(kind, `over ${period}:`, series.output().map((point) => +point[1].toFixed(2)).join(' '));
}
J
stated 'ma over 3: 1 2 3 2 3 4 5 6 7 8
ma over 5: 1 2 3 4 5 3 4 5 6 7
lwma over 3: 1 2 3 1.67 2.67 3.67 4.67 5.67 6.67 7.67' "$(node ramp.cjs)"
