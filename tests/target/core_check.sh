#!/usr/bin/env bash
# core_check.sh MACHINE ELF MAKE_VECTORS GOLDEN DIR: the image of tests/on_target, run in DIR on QEMU's MACHINE,
# prints what the golden files hold: the core's checks, the drift of every effect, the pipeline's output.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
machine=$1 elf=$2 make_vectors=$3 golden=$4 folder=$5
mkdir -p "$folder"
"$make_vectors" "$folder"
"$(dirname "$0")/run_semihosted.sh" "$machine" "$elf" "$folder" | tr -d '\r' >"$folder/console" ||
  { cat "$folder/console"; exit 1; }

for name in core_checks effect_outputs board_output; do
  awk -v wanted="== $name.txt" '/^== / { inside = $0 == wanted; next } inside' "$folder/console" >"$folder/$name.txt"
  difference=$(diff "$golden/$name.txt" "$folder/$name.txt") ||
    fail "$machine: $name.txt is not the golden file: $(head -n 4 <<<"$difference" | paste -sd ' ')"
  echo "$machine: $name: $(wc -l <"$folder/$name.txt") lines, $(wc -w <"$folder/$name.txt") words as in the golden file"
done
! grep -q FAILED "$folder/core_checks.txt" || fail "$machine: $(grep -m 1 FAILED "$folder/core_checks.txt")"
