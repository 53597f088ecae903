#!/usr/bin/env bash
# Package:  Debian 12 libnewlib-arm-none-eabi 3.3.0-1.3+deb12u1: printf(), full and nano.
# Expected: %hhx of the byte -2 is fe and %zu of 300 is 300, as C99 and glibc have it, at least in the full library.
# Seen:     both are built without C99's lengths. The full one prints the byte as 16 bits, fffe. %zu prints "zu" and
#           takes no argument: each one behind it moves by one place, and 7 rows come out as 300. nano prints "hx"
#           and moves the arguments, too. gcc -Wall finds nothing to warn of, for the formats are right.
# Matters:  a hex dump of the serial link grows by two digits wherever a byte was signed and above 7f, and a report of
#           sizes shows other numbers under their names. Cast: (unsigned)(byte & 0xff) with %02x, (unsigned) with %u.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
newlib_on_board
cat >probe.c <<'C'
#include <stdio.h>
int main(void) {
  signed char byte = -2;
  size_t size = 300;
  printf("byte %hhx, then %d\n", byte, 5);
  printf("size %zu, rows %d\n", size, 7);
}
C
gcc -O1 -Wall -Werror probe.c -o probe
stated 'PC: byte fe, then 5
PC: size 300, rows 7
full: byte fffe, then 5
full: size zu, rows 300
nano: byte hx, then -2
nano: size zu, rows 300' "$(
  ./probe | sed 's/^/PC: /'
  on_board -Wall -Werror | sed 's/^/full: /'
  on_board -Wall -Werror --specs=nano.specs | sed 's/^/nano: /'
)"
