#!/usr/bin/env bash
# Package:  Debian 12 srecord 1.64-3: srec_cat -crc16-b-e.
# Expected: -ccitt is the CRC-16 with start value FFFF that protocols call CCITT-FALSE: 29B1 over "123456789".
# Seen:     -ccitt, also the default, gives E5CC, that CRC with 16 more zero bits behind the data. The option for 29B1
#           is called -broken. -xmodem gives XMODEM's 31C3.
# Matters:  sensor streams and calibration tables mostly carry CCITT-FALSE. An image signed at production by
#           `-crc16-b-e ... -ccitt` fails the check of the firmware, or both sides adopt a CRC that nobody else has.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian srecord=1.64-3
printf '123456789' >check.bin
crc() {
  srec_cat check.bin -binary -crc16-b-e 9 "$@" -crop 9 11 -o crc.bin -binary
  od -An -tx1 -j9 crc.bin | tr -d ' '
}
stated 'no option e5cc
-ccitt e5cc
-broken 29b1
-xmodem 31c3' "$(echo "no option $(crc)"; for name in -ccitt -broken -xmodem; do echo "$name $(crc "$name")"; done)"
