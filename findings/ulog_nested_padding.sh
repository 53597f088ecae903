#!/usr/bin/env bash
# Package:  npm @lichtblick/ulog 1.0.0 (PX4's log format), beside @foxglove/ulog 2.3.2.
# Expected: a field "uint8_t[6] _padding0" of a nested type takes six bytes of the message.
# Seen:     it takes one, whatever its count. All behind it is read five bytes early: the second axis has a count of 0
#           at a time of 35 years, the temperature is 1e-39. Nothing is thrown. @foxglove/ulog is right.
# Matters:  PX4 pads nested types to a multiple of 8 bytes, so arrays of them (ESCs, axes) are plain in its logs. The
#           first element is right, the rest is noise that passes for tiny floats and zeros.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
npm_packages @lichtblick/ulog@1.0.0 @foxglove/ulog@2.3.2
cat >read.cjs <<'J'
const { writeFileSync } = require('node:fs');
const filled = (size, write) => { const bytes = Buffer.alloc(size); write(bytes); return bytes; };
const time = (microseconds) => filled(8, (bytes) => bytes.writeBigUInt64LE(BigInt(microseconds)));
const axis = (counts) => Buffer.concat([time(1000), filled(8, (bytes) => bytes.writeInt16LE(counts))]);
const message = (type, ...parts) => {
  const body = Buffer.concat(parts.map((part) => Buffer.from(part)));
  return Buffer.concat([filled(2, (bytes) => bytes.writeUInt16LE(body.length)), Buffer.from(type), body]);
};
writeFileSync('run.ulg', Buffer.concat([
  Buffer.from([0x55, 0x4c, 0x6f, 0x67, 0x01, 0x12, 0x35, 0x01]), time(0), message('B', Buffer.alloc(40)),
  message('F', 'axis:uint64_t timestamp;int16_t counts;uint8_t[6] _padding0;'),
  message('F', 'gyro:uint64_t timestamp;axis[2] axes;float temperature;'),
  message('A', [0, 1, 0], 'gyro'),
  message('D', [1, 0], time(1000), axis(11), axis(12), filled(4, (bytes) => bytes.writeFloatLE(25.5))),
]));
const read = async (name) => {
  const [{ ULog }, { FileReader }] = [require(name), require(`${name}/node`)];
  const log = new ULog(new FileReader('run.ulg'));
  await log.open();
  for await (const { value } of log.readMessages()) {
    if (!value) continue;
    const axes = value.axes.map(({ timestamp, counts }) => `${counts} at ${timestamp}`);
    console.log(`${name}:`, axes.join(', '), 'and', value.temperature.toPrecision(3));
  }
};
read('@lichtblick/ulog').then(() => read('@foxglove/ulog'));
J
stated '@lichtblick/ulog: 11 at 1000, 0 at 1099511627776000 and 1.10e-39
@foxglove/ulog: 11 at 1000, 12 at 1000 and 25.5' "$(node read.cjs)"
