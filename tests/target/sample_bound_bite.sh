#!/usr/bin/env bash
# sample_bound_bite.sh DIR: sample_bound.py and worst_instructions.py find a bound that is too small, planted in copies of
# what they compare the counts with, one part at a time. DIR/sample_cost.elf is the image of sample_bound.sh.
set -euo pipefail
image=$(realpath "$1/sample_cost.elf")
source=$(realpath "$(dirname "$0")/../..")
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
export PYTHONDONTWRITEBYTECODE=1
failures=0
# plant FILE FROM TO: in a fresh copy of tests.
plant() {
  rm -rf "$copy/tests"
  mkdir "$copy/tests"
  cp -r "$source"/tests/{target,bench,reference} "$copy/tests/"
  "$source/tests/proof/plant.py" "$copy/tests/$1" "$2" "$3"
}
# found WHAT SAID PROGRAM...: a Python program in the copy says so, a pattern, and exits 1.
found() {
  local status=0
  (cd "$copy" && /usr/bin/python3 -c "$3") >"$copy/said.txt" 2>&1 || status=$?
  if ((status == 1)) && grep -qE "$2" "$copy/said.txt"; then
    echo "found: $1"
  else
    echo "FAILED: not found: $1: $(tail -n 3 "$copy/said.txt")"
    failures=$((failures + 1))
  fi
}
# of_part PART FROM TO: counted beside the empty table, which is counted first; PART '' is that one alone.
of_part() {
  plant reference/cost.py "$2" "$3"
  found "${1:-empty table}: $3" "^${1:-empty table}: .*: MORE" "
import sys
sys.path.insert(0, 'tests/target')
import sample_bound
parts = sample_bound.parts
sample_bound.parts = lambda *shape: {name: part for name, part in parts(*shape).items() if name == '$1'}
sys.exit(sample_bound.main('$image', 'found', 30, 9))"
}

of_part '' '4600 +' '460 +'
of_part '' '6800 if table.program else 3400' '340'
of_part 'effect 2' '800 * len(table.effects)' '0'
of_part 'effect 15' '1300 * len' '0 * len'
of_part multiply '100 * words' '0'
of_part sine '100 * waves' '0'
of_part 'network 4-32' '36 * len' '3 * len'
of_part 'denoiser 30 x 9' '10 * table.denoiser.taps' 'table.denoiser.taps'

search='
import sys
sys.path.insert(0, "tests/bench")
import worst_instructions
sys.exit(worst_instructions.main("'$image'", "found", 30, 9, 16))'
plant bench/worst_instructions.py 'sample, start = costs.sample_cost(table) + self_test' \
  'sample, start = costs.sample_cost(table) // 2 + self_test'
found 'half of what a sample may take, searched' '^one step a sample: [1-9]' "$search"
plant bench/worst_instructions.py 'return costs.sample_cost(table) + 3' 'return 0 * costs.sample_cost(table) + 0'
found 'nothing for the start of the model, searched' '^up to 64 steps a sample: [1-9]' "$search"
exit $((failures > 0))
