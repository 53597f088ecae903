#!/usr/bin/env bash
# mutation.sh [--one-of N] [--seed S]: do the tests bite? Puts wrong operations into firmware/core, one at a time (one
# of N possible ones, drawn by S; 8 and 1; --one-of 1 tries all), and counts those that make a test fail. Those that do
# not are in build/mutation/survivors.txt. Exits 1 where fewer than 85 % are found. Takes some 3 s a mutant.
set -euo pipefail
cd "$(dirname "$0")/../.."
one_of=8 seed=1
while (($#)); do
  case $1 in
    --one-of) one_of=${2:?} ;;
    --seed) seed=${2:?} ;;
    *) sed -n '2,4s/^# //p' "$0" >&2; exit 2 ;;
  esac
  shift 2
done
source cmake/bootstrap/packages.sh
require_packages "${build_packages[@]}" "${test_packages[@]}" llvm-14-dev || exit 2

build=$PWD/build/mutation
tests=(test_acquisition test_thermometer test_core test_effects property_core golden_core_checks golden_board_output
       golden_effect_outputs)
mkdir -p "$build"

# One build with all mutants inactive. Everything is compiled again if the pass has changed.
pass=(tests/mutation/pass.cpp tests/mutation/operation.cpp)
mapfile -t flags < <(llvm-config-14 --cxxflags | xargs -n 1)
clang++ "${flags[@]}" -std=c++17 -O1 -fPIC -shared "${pass[@]}" -o "$build/new_pass.so"
if ! cmp -s "$build/new_pass.so" "$build/pass.so"; then
  rm -rf "$build/tree" "$build/mutants"
  mv "$build/new_pass.so" "$build/pass.so"
fi
mkdir -p "$build/mutants"
clang++ -c tests/mutation/chosen_mutant.cpp -o "$build/chosen_mutant.o"
export FOG_MUTANTS=$build/mutants
cmake --preset host -B "$build/tree" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_CXX_COMPILER_LAUNCHER= -DCMAKE_CXX_FLAGS="-O1 -g1 -fpass-plugin=$build/pass.so" \
  -DCMAKE_EXE_LINKER_FLAGS="$build/chosen_mutant.o" >/dev/null
cmake --build "$build/tree" --target "${tests[@]}" >/dev/null

# Fast tests first; a test that takes five times as long as without a mutant counts as endless.
TIMEFORMAT=%0U
for test in "${tests[@]}"; do
  echo "600 $test" >"$build/alone.txt"
  seconds=$({ time tests/mutation/killer.sh "$build/tree" "$build/alone.txt" "0 none" >"$build/tried.txt"; } 2>&1)
  grep -q '^survived' "$build/tried.txt" || { echo "$test fails without a mutant" >&2; exit 1; }
  echo "$((5 * seconds + 5)) $test"
done | sort -n >"$build/limits.txt"

sort -u -k1,1 "$build"/mutants/* | awk -v one_of="$one_of" -v seed="$seed" \
  'BEGIN { srand(seed) } rand() * one_of < 1' >"$build/drawn.txt"
xargs -d '\n' -P "$(nproc)" -I{} tests/mutation/killer.sh "$build/tree" "$build/limits.txt" {} \
  <"$build/drawn.txt" >"$build/verdicts.txt"
sed -n 's/^survived //p' "$build/verdicts.txt" | sort -V >"$build/survivors.txt"
cut -d' ' -f1 "$build/verdicts.txt" | sort | uniq -c | sort -rn
awk '{ ++all } $1 != "survived" { ++killed }
  END { printf "%d of %d mutants found, %.1f %%\n", killed, all, 100 * killed / all; exit killed < 0.85 * all }' \
  "$build/verdicts.txt"
