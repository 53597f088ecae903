#!/usr/bin/env bash
# coverage.sh: how much of firmware/core the tests run, lines and branches; what none of them does is marked in
# build/coverage/core.txt. Exits 1 below 98 % of the lines or 90 % of the branches. By clang rather than gcov: that
# counts the branches of the source, not those of every instantiation and of exceptions that the core does not have.
set -euo pipefail
cd "$(dirname "$0")/../.."
source cmake/bootstrap/packages.sh
require_packages "${build_packages[@]}" "${test_packages[@]}" llvm || exit 2

build=build/coverage
cmake --preset host -DFOG_TESTS=ON -B "$build" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_CXX_FLAGS="-O1 -fprofile-instr-generate -fcoverage-mapping" >/dev/null
tests=(test_core test_acquisition test_thermometer test_platform test_fit test_core_properties
       golden_board_output golden_effect_outputs golden_core_checks)
cmake --build "$build" --target "${tests[@]}" >/dev/null
programs=() profiles=()
for test in "${tests[@]}"; do
  LLVM_PROFILE_FILE=$build/$test.profraw "$build/tests/$test" >"$build/said.txt" 2>&1 ||
    { tail -n 20 "$build/said.txt"; exit 1; }
  profiles+=("$build/$test.profraw")
  programs+=(-object "$build/tests/$test")
done
llvm-profdata merge -o "$build/all.profdata" "${profiles[@]}"
mapfile -t sources < <(find firmware/core -name '*.[ch]pp')
llvm-cov show "${programs[@]:1}" -instr-profile "$build/all.profdata" -show-branches=count \
  -show-instantiations=false "${sources[@]}" >"$build/core.txt"
llvm-cov report "${programs[@]:1}" -instr-profile "$build/all.profdata" -show-region-summary=false \
  -show-branch-summary "${sources[@]}" >"$build/summary.txt"
awk '/^TOTAL/ { lines = $7; branches = $10 } NF > 8 && ($7 != "100.00%" || $10 !~ /100.00%|-/) { print }
  END { printf "lines %s, branches %s\n", lines, branches
        exit lines + 0 < 98 || branches + 0 < 90 }' "$build/summary.txt"
