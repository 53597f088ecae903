#!/usr/bin/env bash
# sample_bound.sh IMAGES DIR: no part of a model table costs a sample more than its share of the bound by which a table
# is refused (SPEC.md, "Cost of a sample"), counted by QEMU in the generic image with the longest filters and as many
# levels as then fit into the RAM. And the board has the instructions per us that the bound allows, twice over.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
images=$1 folder=$2
here=$(realpath "$(dirname "$0")") source=$(realpath "$(dirname "$0")/../..")
export PYTHONDONTWRITEBYTECODE=1
mkdir -p "$folder"

core_hz=$(sed -nE "s/^constexpr std::uint32_t kCoreHz = ([0-9']+);/\1/p" \
  "$source/firmware/platform/stm32f405/clock_tree.cpp")
per_us=$(sed -nE 's/^constexpr std::uint32_t kInstructionsPerUs = ([0-9]+);/\1/p' \
  "$source/firmware/core/pipeline/sample_cost.hpp")
((2 * (per_us + 2) * 1000000 <= ${core_hz//\'/})) || fail "$per_us instructions per us and 2 for the self-test: too many"

sed 's/fog::kGenericTaps/fog::kOrNone + fog::kMaxTaps/; s/fog::kGenericLevels/9/' \
  "$source/firmware/model/generic/fog_model.h" >"$folder/fog_model.h"
"$here/build_variant.sh" "$images" stm32f405 sample_cost "$folder/sample_cost.elf" \
  -DFOG_MODEL_HEADER="$(realpath "$folder/fog_model.h")"
/usr/bin/python3 "$here/sample_bound.py" "$folder/sample_cost.elf" "$folder" 30 9
