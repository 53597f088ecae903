#!/usr/bin/env bash
# build_firmware.sh PLATFORM IMAGES [HEADER]: brings the images of the checked-in model, or of HEADER, up to date in
# IMAGES/PLATFORM, so that the tests boot what the sources say. A tree of their own: build/PLATFORM may hold the image
# of somebody's gyro.
set -euo pipefail
platform=$1 images=$2 header=${3:+-DFOG_MODEL_HEADER=$3}
cd "$(dirname "$0")/../.."
folder=$images/$platform
[[ -f $folder/build.ninja ]] || cmake --preset "$platform" -B "$folder" $header
cmake --build "$folder"
