#!/usr/bin/env bash
# bulk_matches_pc.sh MACHINE ELF IN.bin EXPECTED.bin DIR: the bulk image, run in DIR, turns IN.bin into
# EXPECTED.bin to the byte.
set -euo pipefail
machine=$1 elf=$2 input=$3 expected=$4 folder=$5
mkdir -p "$folder"
cp "$input" "$folder/in.bin"
rm -f "$folder/out.bin"
"$(dirname "$0")/run_bulk.sh" "$machine" "$elf" "$folder"
cmp "$expected" "$folder/out.bin"
