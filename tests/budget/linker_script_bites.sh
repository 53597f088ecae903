#!/usr/bin/env bash
# linker_script_bites.sh: the ASSERTs of linker/common_sections.ld refuse what start-up relies on not
# being there, and nothing else.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
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
  [[ $said == *"$verdict"* ]] || fail "$name: expected: $verdict"
}

expect_link linked plain_data ''
expect_link 'a static constructor' static_constructor 'struct A { A() { bss = data; } } a;'
expect_link 'stack reserve' small_stack '' -Wl,--defsym=fog_stack_bytes=512
expect_link linked larger_stack '' -Wl,--defsym=fog_stack_bytes=4096
expect_link '8-byte aligned' odd_stack '' -Wl,--defsym=fog_stack_bytes=2052
expect_link 'region `RAM' too_much_ram 'char big[128 * 1024];'

# What the memory protection is told of a part's memories is what its script says: 2^n bytes as (n - 1) * 2.
# expect_sizes FLASH RAM LENGTHS: of a part with such memories, or how linking it is refused.
expect_sizes() {
  local flash=$1 ram=$2 found
  shift 2
  sed "$@" "$linker/stm32f405.ld" >"$scratch/part.ld"
  arm-none-eabi-g++ -nostdlib -mcpu=cortex-m4 -mthumb -L"$linker" -T"$scratch/part.ld" "$scratch/plain_data.o" \
    -o "$scratch/part.elf"
  found=$(arm-none-eabi-nm "$scratch/part.elf" | awk '/_region_size/ { print $3 "=" $1 }' | sort | tr '\n' ' ')
  echo "memory protection: $found"
  [[ $found == "fog_flash_region_size=$flash fog_ram_region_size=$ram " ]] ||
    fail "expected $flash, $ram"
}
expect_sizes 00000026 00000020 ''
expect_sizes 00000024 0000001e 's/1024K/512K/; s/128K/64K/'
expect_sizes 00000024 00000022 's/1024K/384K/; s/128K/192K/'
if (expect_sizes 0 0 's/0x20000000/0x20008000/') 2>"$scratch/said"; then
  fail "a memory in the middle of its region was linked"
fi
grep -q 'multiple of its size' "$scratch/said"
