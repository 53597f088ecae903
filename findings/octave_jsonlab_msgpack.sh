#!/usr/bin/env bash
# Package:  Debian 12 octave-jsonlab 2.0-2 (octave 7.3.0-2): savemsgpack() and loadmsgpack(); the other side by npm
#           @msgpack/msgpack 3.1.3.
# Expected: MessagePack keeps numbers. What one of the two writes the other reads, -40 as -40 and 20.5 as 20.5.
# Seen:     loadmsgpack() makes an array of the type of its first whole number. [20.5, 20, 300.25] comes as int8 21, 20
#           and 127, and [1, 200, 30000] as 1, 127, 127. Without a whole number it is right. savemsgpack() writes a
#           whole number below -31 that stands alone as 0. No error, no warning.
# Matters:  one sample at a whole degree takes the fractions of all others, and clips them at 127. -40 degrees, where
#           most temperature runs begin, is stored as 0.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian octave=7.3.0-2 octave-jsonlab=2.0-2
npm_packages @msgpack/msgpack@3.1.3
cat >write.cjs <<'J'
const { writeFileSync } = require('node:fs');
const { encode } = require('@msgpack/msgpack');
writeFileSync('read.mp', encode({ none: [20.5, 300.25], one: [20.5, 20, 300.25], counts: [1, 200, 30000] }));
J
node write.cjs
cat >both.m <<'M'
pkg load jsonlab
run = loadmsgpack("read.mp");
for name = {"none", "one", "counts"}
  values = run.(name{1});
  printf("read: %s, %s\n", class(values), mat2str(double(values')));
end
file = fopen("written.mp", "w");
fwrite(file, savemsgpack("", struct("a", -31, "b", -32, "c", int16(-40), "d", -40.5, "e", [-40 -300])));
fclose(file);
M
octave-cli --no-history -q both.m >seen.txt 2>&1
cat >read.cjs <<'J'
const { readFileSync } = require('node:fs');
const { decode } = require('@msgpack/msgpack');
console.log('written:', JSON.stringify(decode(readFileSync('written.mp'))));
J
node read.cjs >>seen.txt
stated 'read: double, [20.5 300.25]
read: int8, [21 20 127]
read: int8, [1 127 127]
written: {"a":-31,"b":0,"c":0,"d":[-40.5],"e":[-40,-300]}' "$(cat seen.txt)"
