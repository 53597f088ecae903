#!/usr/bin/env bash
# platform_check.sh MACHINE ELF DIR WATCHDOG_LINE: the self-check image finds start-up, traps and
# restarts as they must be, and a line of its watchdog step matches WATCHDOG_LINE.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
machine=$1 elf=$2 folder=$3 watchdog_line=$4
mkdir -p "$folder"
status=0
console=$("$(dirname "$0")/run_semihosted.sh" "$machine" "$elf" "$folder") || status=$?
echo "$console"
((status == 0)) && [[ $console =~ $watchdog_line ]]
