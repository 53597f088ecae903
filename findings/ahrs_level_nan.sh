#!/usr/bin/env bash
# Package:  npm ahrs 1.3.3: the Madgwick filter, in its default settings.
# Expected: a sensor at rest and exactly level, accelerometer (0, 0, 1), keeps the attitude 0.
# Seen:     the first update makes the attitude NaN (the correction, of length 0, is normalized), and no later sample
#           heals it. With (0.001, 0, 1) it works. Mahony's filter in the same package is right.
# Matters:  simulated or coarsely quantized data are exactly level. Whoever feeds compensated rates to this filter
#           sees NaN and looks for it in the gyro.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
npm_packages ahrs@1.3.3
cat >level.cjs <<'J'
const AHRS = require('ahrs');
function heading(algorithm, first) {
  const filter = new AHRS({ sampleInterval: 10, algorithm });
  filter.update(0, 0, 0, ...first);
  for (let i = 0; i < 100; i++) filter.update(0, 0, 0, 0.01, 0, 1);
  return filter.getEulerAngles().heading.toFixed(3);
}
console.log('Madgwick, first sample level:', heading('Madgwick', [0, 0, 1]));
console.log('Madgwick, first sample tilted:', heading('Madgwick', [0.001, 0, 1]));
console.log('Mahony, first sample level:', heading('Mahony', [0, 0, 1]));
J
stated 'Madgwick, first sample level: NaN
Madgwick, first sample tilted: 0.000
Mahony, first sample level: 0.000' "$(node level.cjs)"
