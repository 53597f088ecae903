#!/usr/bin/env bash
# bulk_matches_pc.sh MACHINE IMAGES FOGCOMP IN.bin DIR: the bulk image of the folder IMAGES, run in DIR,
# sends for IN.bin what fogcomp replay predicts from the header it was built with, to the byte.
set -euo pipefail
machine=$1 images=$2 fogcomp=$3 input=$4 folder=$5
mkdir -p "$folder"
"$fogcomp" replay "$images/model/fog_model.h" "$input" -o "$folder/expected.bin"
ln -sf "$(realpath "$input")" "$folder/in.bin"
rm -f "$folder/out.bin"
"$(dirname "$0")/run_bulk.sh" "$machine" "$images/fogcomp_bulk.elf" "$folder"
cmp "$folder/expected.bin" "$folder/out.bin"
