#!/usr/bin/env bash
# effects_document.sh FOGCOMP SOURCE: host_tools/EFFECTS.md equals the text generated from the catalogue.
set -euo pipefail
fogcomp=$1 source=$2
diff "$source/host_tools/EFFECTS.md" <("$fogcomp" effects --markdown) ||
  { echo "tests/golden/renew_effects.sh writes it anew" >&2; exit 1; }
echo "$("$fogcomp" effects | grep -c ' - ') effects, as the catalogue has them"
