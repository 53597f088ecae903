#!/usr/bin/env bash
# run_semihosted.sh MACHINE ELF DIR [QEMU OPTION...]: runs an image that ends itself by semihosting on QEMU's MACHINE,
# with DIR as its folder, and passes its console on. The exit code is the image's own, or 124 after
# FOG_QEMU_TIMEOUT_S (default 120).
set -euo pipefail
(($# >= 3)) || { echo "usage: run_semihosted.sh MACHINE ELF DIR [OPTION...]" >&2; exit 2; }
machine=$1
elf=$(realpath "$2")
cd "$3"
# The console is the boards' third serial port; virt's is semihosted too, and it has a boot loader that is not wanted.
emulator=(qemu-system-arm -serial null -serial null -serial stdio -semihosting-config enable=on,target=native)
if [[ $machine == virt ]]; then
  emulator=(qemu-system-riscv32 -bios none -serial null -chardev stdio,id=console
            -semihosting-config enable=on,target=native,chardev=console)
fi
exec timeout --kill-after=1 "${FOG_QEMU_TIMEOUT_S:-120}" \
  "${emulator[@]}" -M "$machine" -display none -monitor none \
  "${@:4}" -kernel "$elf" </dev/null
