#!/usr/bin/env bash
# Package:  npm fili 2.0.3: FirCoeffs, bandpass() and bandstop().
# Expected: between F1 and F2 a band pass has gain 1 and a band stop gain 0.
# Seen:     the band pass has gain -1, and the band stop gain 2: it doubles what it should take out. Both come right
#           with F1 and F2 the other way round. lowpass() and highpass() are right.
# Matters:  the line of a fan or a dither at 150 Hz comes out of the "notch" twice as large, and a band cut out of a
#           rate for comparison has the wrong sign. The magnitude alone shows nothing for the band pass.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
npm_packages fili@2.0.3
cat >gain.cjs <<'J'
const { FirCoeffs } = require('fili');
const gain = (taps, hertz) => {  // of the zero-phase filter: the taps are symmetric
  const centre = (taps.length - 1) / 2;
  return taps.reduce((sum, tap, i) => sum + tap * Math.cos((2 * Math.PI * hertz * (i - centre)) / 1000), 0);
};
for (const [F1, F2] of [[100, 200], [200, 100]]) {
  for (const kind of ['bandpass', 'bandstop']) {
    const taps = new FirCoeffs()[kind]({ order: 200, Fs: 1000, F1, F2 });
    const gains = [0, 150, 300].map((hertz) => Math.round(gain(taps, hertz) * 100) / 100 + 0);
    console.log(`${kind}, F1 = ${F1}, F2 = ${F2}: at 0, 150, 300 Hz`, gains.join(' '));
  }
}
J
stated 'bandpass, F1 = 100, F2 = 200: at 0, 150, 300 Hz 0 -1 0
bandstop, F1 = 100, F2 = 200: at 0, 150, 300 Hz 1 2 1
bandpass, F1 = 200, F2 = 100: at 0, 150, 300 Hz 0 1 0
bandstop, F1 = 200, F2 = 100: at 0, 150, 300 Hz 1 0 1' "$(node gain.cjs)"
