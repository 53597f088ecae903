#!/usr/bin/env bash
# coverage.sh: how much of firmware/core the tests run: lines, and conditions that they have shown to decide by
# themselves (MC/DC). What none of the tests does is marked in build/coverage/core.txt. Exits 1 below 98 % of the lines,
# or if a condition is not shown and conditions_unreachable.txt does not say why no test can (conditions.py).
# By clang rather than gcov: that counts the conditions of the source, not those of every instantiation and of exceptions
# that the core does not have.
set -euo pipefail
(($# == 0)) || { sed -n '2,7s/^# //p' "$0" >&2; exit 2; }
cd "$(dirname "$0")/../.."
source cmake/bootstrap/packages.sh
require_packages "${build_packages[@]}" "${quick_packages[@]}" clang-19 llvm-19 libclang-rt-19-dev || exit 2

build=build/coverage
cmake --preset host -DFOG_TESTS=ON -B "$build" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=clang++-19 \
  -DCMAKE_CXX_FLAGS="-O1 -fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc" >/dev/null
tests=(test_core test_acquisition test_thermometer test_core_properties
       golden_board_output golden_effect_outputs golden_core_checks)
cmake --build "$build" --target "${tests[@]}" >"$build/said.txt" || { tail -n 20 "$build/said.txt"; exit 1; }
programs=() profiles=()
for test in "${tests[@]}"; do
  LLVM_PROFILE_FILE=$build/$test.profraw "$build/tests/$test" >"$build/said.txt" 2>&1 ||
    { tail -n 20 "$build/said.txt"; exit 1; }
  profiles+=("$build/$test.profraw")
  programs+=(-object "$build/tests/$test")
done
llvm-profdata-19 merge -o "$build/all.profdata" "${profiles[@]}"
mapfile -t sources < <(find firmware/core -name '*.[ch]pp')
llvm-cov-19 show "${programs[@]:1}" -instr-profile "$build/all.profdata" -show-branches=count -show-mcdc \
  -show-instantiations=false "${sources[@]}" >"$build/core.txt"
llvm-cov-19 report "${programs[@]:1}" -instr-profile "$build/all.profdata" -show-region-summary=false \
  "${sources[@]}" >"$build/summary.txt"
llvm-cov-19 export "${programs[@]:1}" -instr-profile "$build/all.profdata" "${sources[@]}" >"$build/core.json"
status=0
awk 'NF > 6 && $7 != "100.00%" { print } /^TOTAL/ { exit $7 + 0 < 98 }' "$build/summary.txt" || status=1
tests/bench/conditions.py "$build/core.json" firmware/core tests/bench/conditions_unreachable.txt || status=1
exit "$status"
