#!/usr/bin/env bash
# platform_check.sh MACHINE ELF DIR WATCHDOG_LINE: the self-check image finds start-up, traps and
# restarts as they must be, and a line of its watchdog step matches WATCHDOG_LINE.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
machine=$1 elf=$2 folder=$3 watchdog_line=$4
mkdir -p "$folder"
status=0
# Instructions count as time: the watchdog's clock and the millisecond tick go together, however busy this computer is.
console=$("$(dirname "$0")/run_semihosted.sh" "$machine" "$elf" "$folder" -icount shift=6) || status=$?
echo "$console"
((status == 0)) || fail "$machine: the self-check ends with $status: ${console##*$'\n'}"
[[ $console =~ $watchdog_line ]] || fail "$machine: no line of its watchdog step is '$watchdog_line'"
