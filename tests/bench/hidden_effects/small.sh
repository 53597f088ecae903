#!/usr/bin/env bash
# small.sh SOURCE BUILD MADE CASES: the benchmark on the first CASES development cases, in MADE. The bounds are wide,
# because the cases are few; the targets are in the printed table. The cases are seeded: a violated bound is caused by
# the tool, not by chance.
set -euo pipefail
source=$1 build=$2 made=$3 cases=$4
status=0
"$source/tests/bench/hidden_effects.sh" --cases "$cases" --jobs 2 --build "$build" -o "$made" \
  --stages make,answer,propose,score >"$made/said.txt" 2>"$made/progress.txt" || status=$?
if ((status)); then
  tail -n 1 "$made/progress.txt"
  exit "$status"
fi
sed -n '/^| measure/,/^$/p' "$made/said.txt"

# bound MEASURE LESS|GREATER VALUE: fails if the measure is beyond VALUE, or has no cases.
bound() {
  cat >"$made/check.cmake" <<SCRIPT
file(READ "$made/results.json" text)
string(JSON value GET "\${text}" measures $1 value)
if(NOT value MATCHES "[0-9]" OR value $2 $3)
  message(FATAL_ERROR "$1 is \${value}, bound $3")
endif()
SCRIPT
  cmake -P "$made/check.cmake"
}
bound failed GREATER 0
bound clean_named GREATER 0.25   # none of 2 or 3
bound single_name_right LESS 0.8 # of 4 to 8
bound in_set_0.6 LESS 0.75       # of 4 to 7
bound calibration GREATER 0.3
