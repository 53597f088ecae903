#!/usr/bin/env bash
# Package:  npm mat-for-js 1.1.0; the file by scipy.io of Debian 12 python3-scipy 1.10.1-2.
# Expected: an array of 2 x 2 x 2 in a MAT file comes out as nested arrays of the same numbers, as one of 2 x 3 does.
# Seen:     0 2 2 1 4 6 6 5 for 0 to 7: two numbers are there twice, two are missing, some are out of place. Of the
#           12 of 3 x 2 x 2 four are there twice and four are missing. Nothing is thrown. Two dimensions are right.
# Matters:  runs x axes x samples is the layout of a rate-table campaign. The wrong numbers are real samples of other
#           runs, so their range and scatter look right.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian python3-scipy=1.10.1-2
npm_packages mat-for-js@1.1.0
/usr/bin/python3 - <<'P'
import numpy as np
import scipy.io

runs = {"plane": np.arange(6.0).reshape(2, 3), "cube": np.arange(8.0).reshape(2, 2, 2),
        "block": np.arange(12.0).reshape(3, 2, 2)}
scipy.io.savemat("runs.mat", runs)
P
cat >read.mjs <<'J'
import { readFileSync } from 'node:fs';
import { read } from 'mat-for-js';
const bytes = readFileSync('runs.mat');
const { data } = read(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
for (const name of ['plane', 'cube', 'block']) console.log(`${name}:`, JSON.stringify(data[name]));
J
stated 'plane: [[0,1,2],[3,4,5]]
cube: [[[0,2],[2,1]],[[4,6],[6,5]]]
block: [[[0,8],[2,10]],[[4,2],[6,1]],[[8,6],[10,5]]]' "$(node read.mjs)"
