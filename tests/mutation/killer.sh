#!/usr/bin/env bash
# killer.sh TREE LIMITS MUTANT: tries a mutant ("NUMBER PLACE WHAT"; number 0: none) with the tests of LIMITS
# ("SECONDS TEST" a line), built in TREE, and prints the first that fails, or takes more of a processor than that, or
# "survived"; then PLACE and WHAT.
set -euo pipefail
tree=$(realpath "$1") limits=$(realpath "$2") mutant=$3
golden=$(realpath "$(dirname "$0")/../golden")
export FOG_MUTANT=${mutant%% *} GTEST_FAIL_FAST=1
ulimit -c 0 -v 4000000
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

while read -r seconds test; do
  program=("$tree/tests/$test")
  [[ $test != golden_* ]] || program=("$golden/outputs_match.sh" "$tree/tests/$test" "$golden/${test#golden_}.txt")
  # The shell would say by which signal.
  if ! { (ulimit -t "$seconds" && exec "${program[@]}" </dev/null >/dev/null); } 2>/dev/null; then
    echo "$test ${mutant#* }"
    exit
  fi
done <"$limits"
echo "survived ${mutant#* }"
