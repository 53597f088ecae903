#!/usr/bin/env bash
# forbidden_symbols.sh FILE...: exits 1 if an image or object uses what the firmware promises to do
# without: heap, exceptions, RTTI, virtual functions, guarded statics, and any floating-point arithmetic,
# which the soft-float calling convention turns into calls that have names. Integer division
# (__aeabi_idiv, __aeabi_ldivmod and so on) is none of these.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
(($# > 0)) || { echo "usage: forbidden_symbols.sh FILE..." >&2; exit 2; }

heap='_?(malloc|calloc|realloc|free|sbrk)(_r)?|_Zn[wa].*|_Zd[la].*'
cplusplus='__cxa_.*|_ZT[VIST].*|_Unwind_.*|__gxx_personality.*|__dynamic_cast'
# __aeabi_fmul, dmul, cfcmple, cdcmpeq, f2iz, i2f, ul2d, h2f ...; the names libgcc has beside them.
float='__aeabi_(c?[fd]|u?[il]2[fd]|h2f).*|__(add|sub|mul|div|neg|fix|fixuns)[sd]f.*|__float(un)?[sd]i[sd]f'
forbidden="^($heap|$cplusplus|$float)\$"

status=0
for file in "$@"; do
  names=$(arm-none-eabi-nm --format=posix "$file" | cut -d' ' -f1)
  [[ -n $names ]] || fail "$file: no symbols to look at"
  if found=$(grep -E "$forbidden" <<<"$names"); then
    echo "FAILED: $file: forbidden:" $found >&2
    status=1
  else
    echo "$file: $(wc -l <<<"$names") symbols, none forbidden"
  fi
done
exit "$status"
