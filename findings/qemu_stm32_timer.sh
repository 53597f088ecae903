#!/usr/bin/env bash
# Package:  Debian 12 qemu-system-arm 1:7.2+dfsg-7+deb12u18+b3, machine netduinoplus2 (STM32F405); gcc-arm-none-eabi.
# Expected: TIM2 counts at 84 MHz where the core has 168 MHz, stops without CEN, and starts again at 0 after ARR.
# Seen:     it counts at 1 GHz: 5.95 ticks in a tick of SysTick instead of 0.5. It goes on without CEN, and runs far
#           beyond ARR = 99. SysTick is at 168 MHz, as the real one.
# Matters:  time stamps of samples, budgets and timeouts taken from TIM2 pass in the emulator and are wrong by a
#           factor of 12 on the board. Take SysTick, or count instructions with -icount.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian qemu-system-arm=1:7.2+dfsg-7+deb12u18+b3 gcc-arm-none-eabi=15:12.2.rel1-1
cat >timer.c <<'C'
#define REGISTER(address) (*(volatile unsigned *)(address))
static void call(int operation, const void *argument) {
  register int r0 __asm__("r0") = operation;
  register const void *r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}
static void print(const char *text, unsigned value) {
  char digits[12], *at = digits + 11;
  *at = 0;
  do *--at = '0' + value % 10; while (value /= 10);
  call(4, text), call(4, at), call(4, "\n");
}
static unsigned systick(void) { return REGISTER(0xE000E018); }
static unsigned count(void) { return REGISTER(0x40000024); }
void start(void) {
  REGISTER(0x40023840) = 1;                                 // RCC_APB1ENR: TIM2
  REGISTER(0xE000E014) = 0xFFFFFF, REGISTER(0xE000E018) = 0, REGISTER(0xE000E010) = 5;
  REGISTER(0x4000002C) = 0xFFFFFFFF, REGISTER(0x40000014) = 1, REGISTER(0x40000000) = 1;
  unsigned tick = systick(), from = count();
  while (tick - systick() < 1680000) {}                     // 10 ms
  print("TIM2 MHz: ", (count() - from + 5000) / 10000);
  REGISTER(0x40000000) = 0;                                 // CEN off
  from = count(), tick = systick();
  while (tick - systick() < 1000) {}
  print("counts when stopped: ", count() != from);
  REGISTER(0x4000002C) = 99, REGISTER(0x40000014) = 1, REGISTER(0x40000000) = 1;
  while (tick - systick() < 100000) {}
  print("beyond auto-reload: ", count() > 99);
  call(0x18, (void *)0x20026);
}
__attribute__((section(".vectors"), used)) void *const vectors[] = {(void *)0x20020000, start};
C
cat >flash.ld <<'L'
SECTIONS { . = 0x08000000; .text : { KEEP(*(.vectors)) *(.text*) *(.rodata*) } /DISCARD/ : { *(.ARM*) } }
L
arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -O1 -ffreestanding -nostdlib -T flash.ld timer.c -o timer.elf
stated 'TIM2 MHz: 1000
counts when stopped: 1
beyond auto-reload: 1' \
  "$(timeout 60 qemu-system-arm -M netduinoplus2 -nographic -semihosting -icount shift=0 -kernel timer.elf 2>&1)"
