#!/usr/bin/env bash
# build_firmware.sh PLATFORM: brings build/PLATFORM up to date, so that the tests boot what the sources
# say and not what was built last.
set -euo pipefail
platform=$1
cd "$(dirname "$0")/../.."
[[ -f build/$platform/build.ninja ]] || cmake --preset "$platform"
cmake --build --preset "$platform"
