#!/usr/bin/env bash
# check_budgets.sh BUDGETS.txt BUILD_DIR [IMAGE]: prints what each image of BUDGETS.txt takes (or the one), and exits 1
# if one takes more than it may or is missing.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
(($# == 2 || $# == 3)) || { echo "usage: check_budgets.sh BUDGETS.txt BUILD_DIR [IMAGE]" >&2; exit 2; }
budgets=$1
build=$2
only=${3:-}

# section_bytes SIZES SECTION...: the sum of the sections named, absent ones counting nothing.
section_bytes() {
  local sizes=$1 total=0 name size address wanted
  shift
  while read -r name size address; do
    for wanted in "$@"; do
      [[ $name == "$wanted" ]] && total=$((total + size))
    done
  done <<<"$sizes"
  echo "$total"
}

status=0
refuse() {
  echo "FAILED: over its budget: $1" >&2
  status=1
}

printf '%-28s %7s %7s  %7s %7s %7s %7s\n' image flash of static stack RAM of
while read -r image flash_budget ram_budget _; do
  [[ -z $image || $image == \#* || ( -n $only && $image != "$only" ) ]] && continue
  [[ -f $build/$image ]] || fail "$image: not built"
  sizes=$(arm-none-eabi-size -A "$build/$image")
  flash=$(section_bytes "$sizes" .text .data .seal)
  static=$(section_bytes "$sizes" .data .bss .noinit .dma_buffers)
  stack=$(section_bytes "$sizes" .stack)
  ram=$((static + stack))
  printf '%-28s %7d %7d  %7d %7d %7d %7d\n' \
    "$image" "$flash" "$flash_budget" "$static" "$stack" "$ram" "$ram_budget"
  ((flash <= flash_budget)) || refuse "$image flash by $((flash - flash_budget)) bytes"
  ((ram <= ram_budget)) || refuse "$image RAM by $((ram - ram_budget)) bytes"
done <"$budgets"
exit "$status"
