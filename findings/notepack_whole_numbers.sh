#!/usr/bin/env bash
# Package:  npm notepack.io 3.0.1 (MessagePack), beside @msgpack/msgpack 3.1.3.
# Expected: a number is read as it was written: MessagePack has doubles, and both packages are JavaScript.
# Seen:     whole numbers of 2^64 and more are written as 64-bit integers, modulo 2^64: 1e20 is read as 7.77e18,
#           -1e20 as -7.77e18, and NetCDF's fill value 9.97e36 as 0. Doubles that large have no fraction, so all of
#           them are wrong. Nothing is thrown. @msgpack/msgpack is right.
# Matters:  such values mark missing samples. They come back as samples: a rate of 0 is a good reading.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
npm_packages notepack.io@3.0.1 @msgpack/msgpack@3.1.3
cat >whole.cjs <<'J'
for (const name of ['notepack.io', '@msgpack/msgpack']) {
  const { encode, decode } = require(name);
  const read = [0.1, 2 ** 63, 1e20, -1e20, 1e30, 9.969209968386869e36].map((value) => decode(encode(value)));
  console.log(`${name}:`, read.map((value) => value.toPrecision(3)).join(' '));
}
J
stated 'notepack.io: 0.100 9.22e+18 7.77e+18 -7.77e+18 5.08e+18 0.00
@msgpack/msgpack: 0.100 9.22e+18 1.00e+20 -1.00e+20 1.00e+30 9.97e+36' "$(node whole.cjs)"
