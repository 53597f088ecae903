#!/usr/bin/env bash
# Package:  npm node-mavlink 2.3.0: MavLinkProtocolV1.
# Expected: a message in MAVLink 1 ends before the extension fields, which only MAVLink 2 may send. The payload of
#           RAW_IMU has 26 bytes, that of HIGHRES_IMU 62, that of DEBUG_FLOAT_ARRAY 20.
# Seen:     the extension fields are sent: 29 and 63 bytes. DEBUG_FLOAT_ARRAY, whose array is an extension, cannot be
#           sent at all. The packet is the same as in MAVLink 2 but for the header. MAVLink 2 is right.
# Matters:  a receiver that checks the length of a MAVLink 1 message drops these packets, and one that counts on it
#           looks for the checksum in the wrong place. node-mavlink reads its own packets back without a word.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
npm_packages node-mavlink@2.3.0
cat >send.cjs <<'J'
const { MavLinkProtocolV1, MavLinkProtocolV2, common } = require('node-mavlink');
const imu = Object.assign(new common.RawImu(), { timeUsec: 7n, id: 2, temperature: 2550 });
const highres = Object.assign(new common.HighresImu(), { timeUsec: 7n, fieldsUpdated: 1, id: 3 });
const array = Object.assign(new common.DebugFloatArray(), { timeUsec: 7n, name: 'bias', data: [0.5] });
for (const [version, protocol] of [[1, new MavLinkProtocolV1()], [2, new MavLinkProtocolV2()]]) {
  for (const message of [imu, highres, array]) {
    const { MSG_NAME, FIELDS } = message.constructor;
    const base = FIELDS.filter((field) => !field.extension);
    const ends = base.reduce((end, field) => Math.max(end, field.offset + field.size * (field.length || 1)), 0);
    let sent;
    try {
      sent = `${protocol.serialize(message, 1)[1]} bytes`;
    } catch (error) {
      sent = error.name;
    }
    console.log(`MAVLink ${version}: ${MSG_NAME}: ${ends} without extensions, sent ${sent}`);
  }
}
J
stated 'MAVLink 1: RAW_IMU: 26 without extensions, sent 29 bytes
MAVLink 1: HIGHRES_IMU: 62 without extensions, sent 63 bytes
MAVLink 1: DEBUG_FLOAT_ARRAY: 20 without extensions, sent RangeError
MAVLink 2: RAW_IMU: 26 without extensions, sent 29 bytes
MAVLink 2: HIGHRES_IMU: 62 without extensions, sent 63 bytes
MAVLink 2: DEBUG_FLOAT_ARRAY: 20 without extensions, sent 24 bytes' "$(node send.cjs)"
