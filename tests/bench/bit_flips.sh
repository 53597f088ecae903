#!/usr/bin/env bash
# bit_flips.sh [SEED]: what damaged memory does to the board, in full (the tests draw less): every bit of the model,
# every bit of the code that checks and forms frames and 2,000 of the whole image, each booted once on QEMU's
# STM32F405; then 500 of model, image and constants in RAM flipped while the MPS2 runs, whose watchdog works. Takes
# two hours.
set -euo pipefail
cd "$(dirname "$0")/../.."
seed=${1:-1}
programs=build/host/tests/target/fault_injection
cmake --preset host -DFOG_TESTS=ON >/dev/null
cmake --build build/host --target boot_flips running_flips make_model >/dev/null
images=build/host/firmware_images
tests/target/lenient_images.sh "$images" build/host/tests/target/make_model
echo "== booted with one bit flipped"
tests/target/flip_bits.sh "$programs" netduinoplus2 "$images/lenient/stm32f405.elf" boot all all 2000 "$seed"
echo "== one bit flipped while running"
tests/target/flip_bits.sh "$programs" mps2-an386 "$images/lenient/mps2_an386.elf" running 100 4 300 "$seed"
