#!/usr/bin/env bash
# bulk_matches_pc.sh MACHINE IMAGES FOGCOMP IN.bin DIR: the bulk image of the folder IMAGES, run in DIR,
# sends for IN.bin what fogcomp replay predicts from the header it was built with, to the byte, and
# keeps to its stack budget, if it is for a board.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
machine=$1 images=$2 fogcomp=$3 input=$4 folder=$5
here=$(realpath "$(dirname "$0")")
mkdir -p "$folder"
"$fogcomp" replay "$images/model/fog_model.h" "$input" -o "$folder/expected.bin"
ln -sf "$(realpath "$input")" "$folder/in.bin"
rm -f "$folder/out.bin"
"$here/run_bulk.sh" "$machine" "$images/fogcomp_bulk.elf" "$folder" | tee "$folder/console"
same_bytes "$folder/expected.bin" "$folder/out.bin"
echo "$(stat -c %s "$folder/out.bin") bytes compared, 0 differ"
[[ $machine != virt ]] || exit 0

stack=$(sed -n 's/.*stack \([0-9]*\) of .*/\1/p' "$folder/console")
budget=$(awk -v image="${images##*/}/fogcomp_bulk.elf" '$1 == image { print $4 }' \
  "$here/../budget/budgets.txt")
echo "stack used $stack of a budget of $budget bytes"
((stack <= budget))
