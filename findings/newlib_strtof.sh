#!/usr/bin/env bash
# Package:  Debian 12 libnewlib-arm-none-eabi 3.3.0-1.3+deb12u1: strtof().
# Expected: strtof() gives the float nearest to the text, as glibc's does.
# Seen:     the text is rounded to double first, then to float. A decimal just above the middle of two floats comes
#           out as the lower one: 1.00000005960464477540 as 1 instead of 1 + 2^-23.
# Matters:  a coefficient sent to the board as text, and the same text parsed on the PC, then differ in the last bit,
#           now and then. Send bits, or integers.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
newlib_on_board
cat >probe.c <<'C'
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
int main(void) {
  float value = strtof("1.00000005960464477540", NULL);  // 1 + 2^-24 is 1.000000059604644775390625
  unsigned bits;
  memcpy(&bits, &value, sizeof bits);
  printf("%x\n", bits);
}
C
gcc -O1 -fno-builtin probe.c -lm -o probe
stated 'PC 3f800001
Cortex-M 3f800000' "PC $(./probe)
Cortex-M $(on_board -fno-builtin)"
