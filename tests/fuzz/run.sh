#!/usr/bin/env bash
# run.sh [TARGET...] [-OPTION=VALUE...]: the fuzzers, or some of them, for long: two at a time, with libFuzzer's options
# and -runs=100000000 each unless told otherwise (`sensor_stream -max_len=512`: some thirty frames an input, 30
# minutes). The build, seeds and corpora are those of tests/run.sh.
set -euo pipefail
cd "$(dirname "$0")/../.."
source cmake/bootstrap/packages.sh
require_packages "${build_packages[@]}" "${test_packages[@]}" || exit 2
build=build/tests_sanitized
options=(-runs=100000000) targets=()
for word in "$@"; do
  case $word in
    -max_total_time=*) options=("$word" "${options[@]:1}") ;;
    -*=*) options+=("$word") ;;
    -*) sed -n '2,4s/^# //p' "$0" >&2; exit 2 ;;
    *) targets+=("$word") ;;
  esac
done
((${#targets[@]})) ||
  mapfile -t targets < <(sed -nE 's/^fog_fuzz\(([a-z_]+) .*/\1/p' tests/fuzz/CMakeLists.txt)
cmake --preset tests_sanitized >/dev/null
cmake --build "$build" --target make_seeds "${targets[@]/#/fuzz_}" >/dev/null
"$build/tests/fuzz/make_seeds" "$build/tests/fuzz/seeds"
printf '%s\n' "${targets[@]}" | xargs -P "$(nproc)" -I{} tests/fuzz/fuzz.sh "$build/tests/fuzz/fuzz_{}" \
  "$build/tests/fuzz/seeds/{}" "$build/tests/fuzz/{}" "${options[@]}"
