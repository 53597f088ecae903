#!/usr/bin/env bash
# renew.sh [BUILD]: writes the golden vectors anew, on purpose: when the outputs of an effect are meant to
# change. The commit shows which did.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/host}
cmake --build "$build" --target golden_effect_outputs
"$build/tests/golden_effect_outputs" >tests/golden/effect_outputs.txt
git diff --stat -- tests/golden
