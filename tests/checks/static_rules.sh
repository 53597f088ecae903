#!/usr/bin/env bash
# static_rules.sh ROOT: clang-tidy (bugprone, cert, the analyzer, narrowing) and cppcheck find nothing in the core, each
# source by itself and all headers at once. Deviations, with their reasons, are in firmware/core/.clang-tidy and in
# cppcheck_deviations.txt beside this file. cppcheck's MISRA addon passes over C++, so it is not asked.
set -euo pipefail
cd "${1:?usage: static_rules.sh ROOT}"
deviations=$(realpath "$(dirname "${BASH_SOURCE[0]}")")/cppcheck_deviations.txt
for tool in clang-tidy cppcheck; do
  command -v "$tool" >/dev/null || { echo "no $tool: tests/run.sh --all installs it"; exit 77; }
done

failures=0
cppcheck --language=c++ --std=c++17 --quiet --error-exitcode=1 --enable=warning,performance,portability \
  --suppressions-list="$deviations" -UFOG_OWN_EFFECTS -I firmware firmware/core || failures=1

headers=$(mktemp -d)
trap 'rm -rf "$headers"' EXIT
cp firmware/core/.clang-tidy "$headers"
find firmware/core -name '*.hpp' | sed 's/^firmware\/\(.*\)/#include "\1"/' >"$headers/headers.cpp"
{ find firmware/core -name '*.cpp'; echo "$headers/headers.cpp"; } |
  xargs -n 1 -P "$(nproc)" clang-tidy --quiet --extra-arg=-std=c++17 --extra-arg=-I"$PWD/firmware" \
    2> >(grep -E 'error:|cannot' >&2) || failures=1
exit "$failures"
