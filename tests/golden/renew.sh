#!/usr/bin/env bash
# renew.sh [BUILD]: writes the golden vectors anew, on purpose: when what the board sends is meant to
# change. The commit shows what did.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/host}
for name in effect_outputs board_output; do
  cmake --build "$build" --target "golden_$name"
  "$build/tests/golden_$name" >"tests/golden/$name.txt"
done
git diff --stat -- tests/golden
