#!/usr/bin/env bash
# Package:  Debian 12 libnewlib-arm-none-eabi 3.3.0-1.3+deb12u1: fma() on a Cortex-M.
# Expected: fma(x, y, z) rounds once, as C demands of it and as glibc does.
# Seen:     it is x * y + z, rounded twice: the rounding error of a product, fma(x, x, -(x * x)), comes out as 0.
# Matters:  compensated sums and products (a drift integrated over hours) take their correction from exactly this
#           call. On the PC they gain digits; on the board the correction is always 0, and host and target differ.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
newlib_on_board
cat >probe.c <<'C'
#include <math.h>
#include <stdio.h>
int main(void) {
  volatile double x = 1 + 0x1p-30;
  volatile double product = x * x;
  printf("error of the product: %g\n", fma(x, x, -product));
}
C
gcc -O1 -fno-builtin probe.c -lm -o probe
stated 'PC, error of the product: 8.67362e-19
Cortex-M, error of the product: 0' "PC, $(./probe)
Cortex-M, $(on_board -fno-builtin)"
