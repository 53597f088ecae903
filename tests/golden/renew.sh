#!/usr/bin/env bash
# renew.sh [BUILD]: writes the model that images are built with by default (quickstart's), the golden vectors and the
# catalogue's document anew, on purpose: when what the board sends is meant to change. The commit shows what did.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/tests}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cmake --build "$build" --target fogcomp
"$build/fogcomp" simulate -o "$work/run.bin" --profile paper --preset paper --rate 200 --format stream --seed 1
"$build/fogcomp" fit "$work/run.bin" -o "$work/gyro.model" --effects bias,bias_temperature:order=2,temperature_rate \
  --network 6
"$build/fogcomp" export "$work/gyro.model" -o firmware/model/fog_model.h --sample-rate 200
tests/golden/renew_effects.sh "$build"
for name in board_output core_checks spec_functions spec_stream; do
  cmake --build "$build" --target "golden_$name"
  "$build/tests/golden_$name" >"tests/golden/$name.txt"
done
git diff --stat -- tests/golden firmware/model host_tools/EFFECTS.md
