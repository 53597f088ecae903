#!/usr/bin/env bash
# renew_effects.sh [BUILD]: writes anew, on purpose, what follows from the effects' headers: the document of the
# catalogue and what the board computes of each effect. BUILD is configured with the preset `tests`. The commit shows
# what changed.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/tests}
cmake --build "$build" --target fogcomp golden_effect_outputs
"$build/fogcomp" effects --markdown >host_tools/EFFECTS.md
"$build/tests/golden_effect_outputs" >tests/golden/effect_outputs.txt
