#!/usr/bin/env bash
# Package:  npm dsp.js 1.0.1: RFFT, beside FFT of the same package.
# Expected: a wave of amplitude 1 with 8 periods in the samples has an amplitude of 1 in bin 8, whatever its phase, and
#           0 elsewhere; bin 8 of 64 samples at 200 Hz is at 25 Hz.
# Seen:     RFFT has a sine in bin 7, a cosine in bin 8, and what lies between in both: 0.71 each at an eighth of a
#           turn. FFT has it in bin 8. getBandFrequency(8) of both is 26.56 Hz, half a bin too high.
# Matters:  the line of a dither or a compressor has another frequency and height with each start of a recording, and
#           averaged spectra have two lines where the gyro has one.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
npm_packages dsp.js@1.0.1
cat >line.cjs <<'J'
const DSP = require('dsp.js');
const size = 64;
for (const kind of ['RFFT', 'FFT']) {
  for (const turns of [0, 1 / 8, 1 / 4]) {
    const wave = Float64Array.from({ length: size }, (_, i) => Math.cos(2 * Math.PI * ((8 * i) / size - turns)));
    const transform = new DSP[kind](size, 200);
    transform.forward(wave);
    const lines = [];
    transform.spectrum.forEach((height, bin) => height > 0.01 && lines.push(`bin ${bin}: ${height.toFixed(2)}`));
    console.log(`${kind}, cosine late by ${turns} turns:`, lines.join(', '));
  }
  console.log(`${kind}, bin 8: ${new DSP[kind](size, 200).getBandFrequency(8).toFixed(2)} Hz`);
}
J
stated 'RFFT, cosine late by 0 turns: bin 8: 1.00
RFFT, cosine late by 0.125 turns: bin 7: 0.71, bin 8: 0.71
RFFT, cosine late by 0.25 turns: bin 7: 1.00
RFFT, bin 8: 26.56 Hz
FFT, cosine late by 0 turns: bin 8: 1.00
FFT, cosine late by 0.125 turns: bin 8: 1.00
FFT, cosine late by 0.25 turns: bin 8: 1.00
FFT, bin 8: 26.56 Hz' "$(node line.cjs)"
