#!/usr/bin/env bash
# effects.sh [BUILD]: the host tests that go through the effects, for whoever adds or changes one. BUILD is configured
# with the preset `tests`. tests/run.sh runs these and all others.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/tests}
cmake --build "$build" --target fogcomp fit_sweep test_effects
"$build/tests/test_effects" --gtest_brief=1
"$build/tests/fit_sweep" --count 80 --rows 64
# What is generated from the catalogue knows no effects of a user's own.
if ! grep -q '^FOG_OWN_EFFECTS:[A-Z]*=.' "$build/CMakeCache.txt"; then
  cmake --build "$build" --target golden_effect_outputs
  tests/golden/outputs_match.sh "$build/tests/golden_effect_outputs" tests/golden/effect_outputs.txt
  tests/integration/effects_document.sh "$build/fogcomp" .
fi
tests/integration/every_effect.sh "$build/fogcomp"
tests/integration/help.sh "$build/fogcomp"
echo "all tests that see the effects passed"
