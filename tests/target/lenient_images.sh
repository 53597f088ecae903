#!/usr/bin/env bash
# lenient_images.sh IMAGES MAKE_MODEL: the product images of the checked-in model, but for the flags that make a rate
# not valid: IMAGES/lenient/PLATFORM.elf and fog_model.h. They mark rates valid from the first second on, for tests that
# look for such frames.
set -euo pipefail
images=$1 make_model=$2
here=$(dirname "$(realpath "$0")")
mkdir -p "$images/lenient"
"$make_model" "$images/lenient/fog_model.h" lenient "$here/../../firmware/model/fog_model.h"
for platform in stm32f405 mps2_an386; do
  "$here/build_variant.sh" "$images" "$platform" fogcomp "$images/lenient/$platform.elf" \
    -DFOG_MODEL_HEADER="$(realpath "$images/lenient/fog_model.h")"
done
