#!/usr/bin/env bash
# bulk_refuses_missing_input.sh MACHINE ELF DIR: without in.bin the bulk image says so and exits 1.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
machine=$1 elf=$2 folder=$3
mkdir -p "$folder"
rm -f "$folder/in.bin"
status=0
console=$("$(dirname "$0")/run_semihosted.sh" "$machine" "$elf" "$folder") || status=$?
echo "exit code $status: $console"
((status == 1)) && [[ $console == *"no in.bin"* ]]
