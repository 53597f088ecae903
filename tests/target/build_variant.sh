#!/usr/bin/env bash
# build_variant.sh IMAGES PLATFORM TARGET OUT.elf OPTION...: the image TARGET with a model header or choices of its own
# (-DFOG_MODEL_HEADER=, -DFOG_BOARD=, -DFOG_OUTPUT=, -DFOG_TEMPERATURE=, -DFOG_RESET_CLOCK=, -DFOG_SYNC=). All tests
# share one tree in IMAGES, in turn, so that the core is compiled once.
set -euo pipefail
images=$1 platform=$2 target=$3 out=$4
shift 4
source=$(realpath "$(dirname "$0")/../..")
tree=$images/variants/$platform
mkdir -p "$tree"
exec 9>"$tree.lock"
flock 9
{ cmake -S "$source" -B "$tree" --preset "$platform" \
  -UFOG_MODEL_HEADER -UFOG_BOARD -UFOG_OUTPUT -UFOG_TEMPERATURE -UFOG_RESET_CLOCK \
  -UFOG_SYNC "$@" &&
  cmake --build "$tree" --target "$target"; } >"$tree.log" 2>&1 || { cat "$tree.log"; exit 1; }
cp "$tree/$target.elf" "$out"
