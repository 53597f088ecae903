#!/usr/bin/env bash
# outputs_match.sh PROGRAM GOLDEN: the program's output equals the golden file.
set -euo pipefail
diff "$2" <("$1") ||
  { echo "tests/golden/renew.sh writes it anew where that is meant (after a new effect: renew_effects.sh)" >&2; \
    exit 1; }
echo "$(wc -l <"$2") lines of golden vectors, $(wc -w <"$2") words"
