#!/usr/bin/env bash
# effects_document.sh FOGCOMP SOURCE: host_tools/EFFECTS.md is what the catalogue says. To renew it on purpose:
# build/host/fogcomp effects --markdown >host_tools/EFFECTS.md
set -euo pipefail
fogcomp=$1 source=$2
diff "$source/host_tools/EFFECTS.md" <("$fogcomp" effects --markdown)
echo "$(grep -c '^## ' "$source/host_tools/EFFECTS.md") effects, as the catalogue has them"
