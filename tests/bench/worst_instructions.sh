#!/usr/bin/env bash
# worst_instructions.sh [RUNS [SEED]]: searches the model table and the stream with which a sample costs the board
# most, in instructions counted by QEMU, of the generic image with the longest filters and as many levels as then fit
# into the RAM. Fails if the dearest sample found takes as long as the fastest sensor line takes to fill the board's
# buffer. 200 runs take two minutes of processor time.
set -euo pipefail
cd "$(dirname "$0")/../.."
runs=${1:-200} seed=${2:-1}
images=build/host/firmware_images found=build/host/worst_instructions
mkdir -p "$found"

# In the time of the buffer's bytes, of 10 bits each; an instruction takes a cycle at least.
core_hz=$(sed -nE "s/^constexpr std::uint32_t kCoreHz = ([0-9']+);/\1/p" firmware/platform/stm32f405/clock_tree.cpp)
buffer=$(sed -nE 's/^RingBuffer<([0-9]+)> received;/\1/p' firmware/platform/stm32f405/sample_source.cpp)
line=$(sed -nE "s/^constexpr std::uint32_t kMaxSensorBaud = ([0-9']+);/\1/p" firmware/core/frames/serial_line.hpp)
budget=$((buffer * 10 * ${core_hz//\'/} / ${line//\'/}))

sed 's/fog::kGenericTaps/fog::kOrNone + fog::kMaxTaps/; s/fog::kGenericLevels/9/' firmware/model/generic/fog_model.h \
  >"$found/fog_model.h"
tests/target/build_variant.sh "$images" stm32f405 sample_cost "$found/sample_cost.elf" \
  -DFOG_MODEL_HEADER="$PWD/$found/fog_model.h"
/usr/bin/python3 tests/bench/worst_instructions.py "$found/sample_cost.elf" "$found" 30 9 "$runs" "$seed" |
  tee "$found/said.txt"
worst=$(sed -n 's/^one step a sample: \([0-9]*\) instructions$/\1/p' "$found/said.txt")
echo "the dearest sample found takes $worst instructions of $budget"
((0 < worst && worst < budget))
