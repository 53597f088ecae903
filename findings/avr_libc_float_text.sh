#!/usr/bin/env bash
# Package:  Debian 12 avr-libc 1:2.0.0+Atmel3.6.2-3, gcc-avr 1:5.4.0+Atmel3.6.2-3: strtod(), printf() with printf_flt.
#           Run on an ATmega328P in simavr 1.6+dfsg-3.
# Expected: text becomes the nearest float, as glibc's strtof() has it. %.3f prints the value, to three decimals.
# Seen:     435 of 1000 decimals with eight digits are one unit of the last place off, and 3.4028235e38 is infinity.
#           printf() has eight digits and writes zeros behind them: 123456.789 is 123456.790, and 2^32 is 4294967300.
# Matters:  coefficients sent as text are not those of the PC, nearly every second time. Seconds since power-on are
#           printed in steps of 10 ms after 28 hours. Send bits, or integers.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian avr-libc=1:2.0.0+Atmel3.6.2-3 gcc-avr=1:5.4.0+Atmel3.6.2-3 simavr=1.6+dfsg-3
cat >text.c <<'C'
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef __AVR__
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#define strtof strtod  // a double is a float here
static int put(char character, FILE *stream) {
  while (!(UCSR0A & 1 << UDRE0)) {}
  UDR0 = character;
  return 0;
}
static FILE serial = FDEV_SETUP_STREAM(put, 0, _FDEV_SETUP_WRITE);
#endif
static void show(const char *text) {
  float value = strtof(text, 0);
  uint32_t bits;
  memcpy(&bits, &value, 4);
  printf("bits %s %08lx\n", text, (unsigned long)bits);
}
int main(void) {
#ifdef __AVR__
  UCSR0B = 1 << TXEN0;
  stdout = &serial;
#endif
  volatile float seconds = 123456.789f, counts = 4294967296.0f;
  printf("print %.3f %.0f\n", (double)seconds, (double)counts);
  show("3.4028235e38");
  uint32_t random = 1;
  for (int i = 0; i < 1000; i++) {
    char text[20];
    random = random * 1664525 + 1013904223;
    sprintf(text, "%lu.%07lue-%d", 1 + (unsigned long)(random >> 8) % 9, (unsigned long)(random >> 4) % 10000000,
            (int)(random >> 28) % 8);
    show(text);
  }
#ifdef __AVR__
  cli();
  sleep_mode();  // ends the simulation
#endif
}
C
avr-gcc -mmcu=atmega328p -O1 text.c -Wl,-u,vfprintf -lprintf_flt -lm -o text.elf
timeout 60 simavr -m atmega328p -f 16000000 text.elf 2>&1 | grep -oE '(print|bits) [-0-9a-fe. ]*[0-9a-f]' >board.txt
gcc -O1 text.c -o text
./text >pc.txt
stated 'PC 123456.789 4294967296
board 123456.790 4294967300
board 3.4028235e38 7f800000
of 1000 decimals 435 differ' "$(
  sed -n 's/^print/PC/p' pc.txt
  sed -n 's/^print/board/p; s/^bits 3.4028235e38/board &/p' board.txt | sed 's/bits //'
  echo "of $(grep -c 'e-' board.txt) decimals $(diff board.txt pc.txt | grep -c '^<.*e-') differ"
)"
