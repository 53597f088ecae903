#!/usr/bin/env bash
# images_are_reproducible.sh PLATFORM: the firmware built from a copy of the sources in another folder
# is the same to the byte as in build/PLATFORM.
set -euo pipefail
platform=$1
root=$(realpath "$(dirname "$0")/../..")
build=$root/build/$platform
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT

cp -r "$root"/{CMakeLists.txt,CMakePresets.json,cmake,firmware,linker} "$copy"
cd "$copy"
cmake --preset "$platform" -DFOG_MODEL_HEADER="$build/model/fog_model.h" >/dev/null
cmake --build --preset "$platform" >/dev/null
for image in "$build"/*.elf "$build"/*.bin "$build"/*.hex; do
  cmp "$image" "build/$platform/${image##*/}"
done
