#!/usr/bin/env bash
# bit_flips.sh [SEED]: what damaged memory does to the board, in full (the tests draw less): every bit of the model, every
# bit of the code that checks and forms frames and 2,000 of the whole image, each booted once on QEMU's STM32F405; then 500
# of model, image and constants in RAM flipped while the MPS2 runs, whose watchdog works. Takes two hours.
set -euo pipefail
cd "$(dirname "$0")/../.."
seed=${1:-1}
programs=build/host/tests/target/fault_injection
cmake --preset host >/dev/null
cmake --build build/host --target boot_flips running_flips >/dev/null
for board in stm32f405 mps2_an386; do
  cmake --preset "$board" >/dev/null
  cmake --build "build/$board" --target fogcomp >/dev/null
done
echo "== booted with one bit flipped"
tests/target/flip_bits.sh "$programs" netduinoplus2 build/stm32f405/fogcomp.elf boot all all 2000 "$seed"
echo "== one bit flipped while running"
tests/target/flip_bits.sh "$programs" mps2-an386 build/mps2_an386/fogcomp.elf running 100 4 300 "$seed"
