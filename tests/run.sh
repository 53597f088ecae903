#!/usr/bin/env bash
# All tests, on Debian 12 from nothing: sets the machine up, builds, runs CTest for the optimised build (property,
# statistics, golden, target, integration, budget) and for the one under ASan and UBSan with every fixed-point
# operation checked for overflow (unit, property again, and a million inputs of fuzzing).
set -euo pipefail
cd "$(dirname "$0")/.."
source cmake/bootstrap/packages.sh

require_packages "${build_packages[@]}" "${test_packages[@]}" || exit 2

# Many tests build the firmware or the tree again, all but a few of the objects as before.
export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
export CCACHE_DIR=$PWD/build/ccache CCACHE_NOHASHDIR=1

cmake --preset host -DFOG_TESTS=ON -DFOG_UNIT_TESTS=OFF
CCACHE_BASEDIR=$PWD cmake --build build/host # so that a copy of the tree has the same names (own_effect.sh)
cmake --preset host_sanitized
CCACHE_DISABLE=1 cmake --build build/host_sanitized # nothing of it is built again: the cache would read it all twice

results=build/host/test_results.txt
status=0
jobs=$(($(nproc) + 1)) # some tests wait, for a browser or for bytes on a line
ctest --test-dir build/host --output-on-failure --no-tests=error -j "$jobs" | tee "$results" || status=1
ctest --test-dir build/host_sanitized --output-on-failure --no-tests=error -j "$jobs" -L 'unit|property|fuzz' |
  tee -a "$results" || status=1

# The end, both builds together: what failed by name, then one plain line of counts.
passed=$(grep -cE '^ *[0-9]+/[0-9]+ Test .* Passed ' "$results" || true)
skipped=$(grep -cE '^ *[0-9]+/[0-9]+ Test .*\*\*\*Skipped' "$results" || true)
failed=$(($(grep -cE '^ *[0-9]+/[0-9]+ Test ' "$results" || true) - passed - skipped))
grep -E '^ *[0-9]+/[0-9]+ Test ' "$results" | grep -vE ' Passed |\*\*\*Skipped' |
  sed -E 's/^ *[0-9]+\/[0-9]+ Test +#[0-9]+: ([^ ]+) .*/failed: \1/' || true
echo "$passed passed, $failed failed, $skipped skipped"
exit "$status"
