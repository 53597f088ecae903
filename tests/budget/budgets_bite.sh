#!/usr/bin/env bash
# budgets_bite.sh BUILD_DIR: a budget of one byte less than an image takes is refused, the exact one is
# not. So check_budgets.sh measures something.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
build=$1
check=$(dirname "$0")/check_budgets.sh
budgets=$(mktemp)
trap 'rm -f "$budgets"' EXIT
image=stm32f405/fogcomp.elf

echo "$image 1000000 1000000" >"$budgets"
read -r _ flash _ _ _ ram _ < <("$check" "$budgets" "$build" | tail -n 1)
echo "$image takes $flash bytes of flash and $ram of RAM"
((flash > 0 && ram > 0))

# expect_status STATUS FLASH RAM
expect_status() {
  local status=0
  echo "$image $2 $3" >"$budgets"
  "$check" "$budgets" "$build" || status=$?
  ((status == $1)) || fail "budget $2, $3: exit code $status, not $1"
}
expect_status 0 "$flash" "$ram"
expect_status 1 $((flash - 1)) "$ram"
expect_status 1 "$flash" $((ram - 1))
echo "missing/fogcomp.elf 1 1" >"$budgets"
! "$check" "$budgets" "$build"
