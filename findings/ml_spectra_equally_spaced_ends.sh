#!/usr/bin/env bash
# Package:  npm ml-spectra-processing 14.35.1: xyEquallySpaced().
# Expected: a constant put on an even time base is that constant, and a line is the line, from first to last point.
# Seen:     a constant of 5 begins with 3.75 and ends with 4.6875, a line of 0 to 4 begins with 0.0625 and ends with
#           3.6875. Beyond the data all counts as 0, and half a step of it is averaged in. Between, all is right.
#           variant "slot" keeps the ends, and puts 0 where no sample falls into a step.
# Matters:  a rate on a large bias begins with a step of a quarter or more, which a drift or Allan analysis takes for
#           start-up behaviour. Leave the first and the last point out.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
npm_packages ml-spectra-processing@14.35.1
cat >space.mjs <<'J'
import { xyEquallySpaced } from 'ml-spectra-processing';
const show = (name, x, y, options) => console.log(`${name}:`, [...xyEquallySpaced({ x, y }, options).y].join(' '));
const uneven = [0, 1, 2, 4, 5, 6, 10];
const constant = uneven.map(() => 5);
const grid = { from: 0, to: 10, numberOfPoints: 6 };
show('constant', uneven, constant, grid);
show('constant, slot', uneven, constant, { ...grid, variant: 'slot' });
show('line', [0, 1, 2, 3, 4], [0, 1, 2, 3, 4], { from: 0, to: 4, numberOfPoints: 9 });
J
stated 'constant: 3.75 5 5 5 5 4.6875
constant, slot: 5 5 5 5 0 5
line: 0.0625 0.5 1 1.5 2 2.5 3 3.5 3.6875' "$(node space.mjs)"
