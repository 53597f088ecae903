#!/usr/bin/env bash
# Package:  Debian 12 cppcheck 2.10-2 with its addon "misra".
# Expected: the rules are applied to C++ too, or a line says that they are not.
# Seen:     the same text has findings as a .c file and none as .cpp; exit code 0, and not a word.
# Matters:  firmware for gyros is often C++ and often has to show MISRA. A CI job with this addon is green there
#           because nothing was checked.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian cppcheck=2.10-2
cat >scale.c <<'C'
#include <stdint.h>
int16_t scale(int16_t counts, int32_t gain) {
  int16_t result = 0;
  if (counts > 3) result = counts * gain >> 15;
  goto out;
out:
  return result;
}
C
cp scale.c scale.cpp
rules() {
  local exit_code=0
  cppcheck --addon=misra --enable=style --quiet --error-exitcode=1 "$1" >found.log 2>&1 || exit_code=$?
  echo "$1: exit $exit_code, rules: $(grep -o 'misra-c2012-[0-9.]*' found.log | sort -u | paste -sd ' ')"
}
stated 'scale.c: exit 1, rules: misra-c2012-10.1 misra-c2012-15.1 misra-c2012-8.4
scale.cpp: exit 0, rules: ' "$(rules scale.c; rules scale.cpp)"
