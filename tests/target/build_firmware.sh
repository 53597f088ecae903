#!/usr/bin/env bash
# build_firmware.sh PLATFORM IMAGES: brings the images of the checked-in model up to date in IMAGES/PLATFORM,
# so that the tests boot what the sources say. A tree of their own: build/PLATFORM may hold the image
# of somebody's gyro.
set -euo pipefail
platform=$1 images=$2
cd "$(dirname "$0")/../.."
folder=$images/$platform
[[ -f $folder/build.ninja ]] || cmake --preset "$platform" -B "$folder"
cmake --build "$folder"
