#!/usr/bin/env bash
# header_matches_pc.sh IMAGES FOGCOMP HEADER DIR PLATFORMS STREAM.bin...: bulk images built with the model HEADER
# send for each sensor stream what `fogcomp replay` does. PLATFORMS: words of `stm32f405 mps2_an386`.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
images=$1 fogcomp=$2 header=$(realpath "$3") folder=$4 platforms=$5
shift 5
here=$(realpath "$(dirname "$0")")
mkdir -p "$folder"
for stream in "$@"; do "$fogcomp" replay "$header" "$stream" -o "$folder/expected_${stream##*/}"; done
declare -A machines=([stm32f405]=netduinoplus2 [mps2_an386]=mps2-an386)
for platform in $platforms; do
  build=$folder/$platform
  mkdir -p "$build"
  "$here/build_variant.sh" "$images" "$platform" fogcomp_bulk "$build/fogcomp_bulk.elf" -DFOG_MODEL_HEADER="$header"
  for stream in "$@"; do
    ln -sf "$(realpath "$stream")" "$build/in.bin"
    rm -f "$build/out.bin"
    "$here/run_semihosted.sh" "${machines[$platform]}" "$build/fogcomp_bulk.elf" "$build"
    same_bytes "$folder/expected_${stream##*/}" "$build/out.bin"
    echo "$platform, ${stream##*/}: $(stat -c %s "$build/out.bin") bytes compared, 0 differ"
  done
done
