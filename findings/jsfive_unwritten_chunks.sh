#!/usr/bin/env bash
# Package:  npm jsfive 0.4.2; the file by Debian 12 python3-h5py 3.7.0-8.
# Expected: samples of a chunk that was never written read as the fill value of the data set (-999 here).
# Seen:     they are missing from the array. Those of a chunk written in part are -999. A loop that adds them up gets
#           NaN, JSON has null, and forEach() passes over them.
# Matters:  a logger that reserves 24 h and stops early, or skips a chunk in an outage, leaves such chunks. Code that
#           looks for the fill value does not find the gap.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian python3-h5py=3.7.0-8
npm_packages jsfive@0.4.2
/usr/bin/python3 - <<'P'
import h5py
with h5py.File("run.h5", "w") as file:
    counts = file.create_dataset("counts", (12,), chunks=(4,), dtype="i4", fillvalue=-999)
    counts[0:2] = [7, 8]
    counts[8:12] = [9, 10, 11, 12]
    print("h5py:  ", counts[:].tolist())
P
cat >read.mjs <<'J'
import { readFileSync } from 'node:fs';
import { File } from 'jsfive';
const counts = new File(new Uint8Array(readFileSync('run.h5')).buffer, 'run.h5').get('counts');
console.log('fill value', counts.fillvalue);
console.log('jsfive:', JSON.stringify(counts.value));
let seen = 0;
counts.value.forEach(() => seen++);
console.log('forEach sees', seen, 'of', counts.value.length);
J
stated 'fill value -999
jsfive: [7,8,-999,-999,null,null,null,null,9,10,11,12]
forEach sees 8 of 12' "$(node read.mjs)"
