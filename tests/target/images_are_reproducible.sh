#!/usr/bin/env bash
# images_are_reproducible.sh PLATFORM IMAGES: product and bulk image built from a copy of the sources in another
# folder are the same to the byte as in IMAGES/PLATFORM.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
platform=$1 images=$2
root=$(realpath "$(dirname "$0")/../..")
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT

cp -r "$root"/{CMakeLists.txt,CMakePresets.json,cmake,firmware,linker} "$copy"
mkdir "$copy/tests"
cp -r "$root/tests/on_target" "$copy/tests"
cd "$copy"
cmake --preset "$platform" >/dev/null
cmake --build --preset "$platform" --target fogcomp fogcomp_bulk >/dev/null
for image in "$images/$platform"/fogcomp{,_bulk}.{elf,bin,hex}; do
  same_bytes "$image" "build/$platform/${image##*/}"
done
