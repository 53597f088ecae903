#!/usr/bin/env bash
# linker_script_bites.sh: the ASSERTs of linker/common_sections.ld refuse what start-up relies on not
# being there, and nothing else.
set -euo pipefail
linker=$(realpath "$(dirname "$0")/../../linker")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

start='extern "C" { int data = 7; int bss; void fog_reset_handler() { bss = data; } }'

# expect_link VERDICT NAME CODE [OPTION...]: VERDICT is "linked" or a word of the refusal.
expect_link() {
  local verdict=$1 name=$2 code=$3 said=linked
  shift 3
  echo "$start $code" | arm-none-eabi-g++ -mcpu=cortex-m4 -mthumb -mfloat-abi=soft -Os \
    -ffreestanding -fno-exceptions -x c++ -c - -o "$scratch/$name.o"
  arm-none-eabi-g++ -nostdlib -mcpu=cortex-m4 -mthumb -L"$linker" -T"$linker/stm32f405.ld" "$@" \
    "$scratch/$name.o" -o "$scratch/$name.elf" 2>"$scratch/said" || said=$(<"$scratch/said")
  echo "$name: ${said##*/}"
  [[ $said == *"$verdict"* ]] || { echo "$name: expected: $verdict" >&2; exit 1; }
}

expect_link linked plain_data ''
expect_link 'a static constructor' static_constructor 'struct A { A() { bss = data; } } a;'
expect_link 'stack reserve' small_stack '' -Wl,--defsym=fog_stack_bytes=512
expect_link linked larger_stack '' -Wl,--defsym=fog_stack_bytes=4096
expect_link '8-byte aligned' odd_stack '' -Wl,--defsym=fog_stack_bytes=2052
expect_link 'region `RAM' too_much_ram 'char big[128 * 1024];'
