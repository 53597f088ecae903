#!/usr/bin/env bash
# conditions_bite.sh: tests/bench/conditions.py finds each kind of fault in what llvm-cov exports and in the list of
# unreachable conditions, planted in right ones of a small folder. The export has the fields of llvm-cov 19.
set -euo pipefail
here=$(realpath "$(dirname "$0")")
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
cd "$tree"
mkdir core
cat >core/one.hpp <<'CODE'
bool both(bool a, bool b) {
  return a && b;
}
int pick(int n) {
  if (n > 2) return 1;
  return 0;
}
CODE
cat >right.json <<'JSON'
{"data": [{"functions": [
  {"filenames": ["core/one.hpp"], "branches": [[2, 10, 2, 11, 3, 2, 0, 0, 6], [2, 15, 2, 16, 1, 2, 0, 0, 6]],
   "mcdc_records": [[2, 10, 2, 16, 1, 4, 0, 0, 5, [true, true]]]},
  {"filenames": ["core/one.hpp"], "branches": [[5, 7, 5, 12, 4, 3, 0, 0, 4]], "mcdc_records": []}]}]}
JSON
failures=0
# judge NAME EXPECTED SAID FROM TO [UNREACHABLE]: of the export with FROM replaced by TO. SAID: the line that it must have.
judge() {
  cp right.json export.json
  [[ $4 == "$5" ]] || "$here/../proof/plant.py" export.json "$4" "$5"
  printf '%s\n' "${6:-}" >unreachable.txt
  local status=0
  "$here/../bench/conditions.py" export.json core unreachable.txt >said.txt 2>&1 || status=$?
  if ((status == $2)) && grep -qxF -e "$3" said.txt; then return; fi
  echo "FAILED: $1: exit code $status: $(cat said.txt)"
  failures=$((failures + 1))
}
shown='[true, true]' all='all                     3      3            0' one='all                     3      2            1'
judge 'all are shown' 0 "$all" '"' '"'
judge 'one is shown by no test, and listed' 0 "$one" "$shown" '[true, false]' 'one.hpp | b | no input makes it so'
judge 'a condition of a decision is not shown' 1 'not shown, was true and false: core/one.hpp:2:15: b' \
  "$shown" '[true, false]'
judge 'a decision of one condition was never false' 1 'not shown, was true: core/one.hpp:5:7: n > 2' '4, 3, 0' '4, 0, 0'
judge 'one was never evaluated' 1 'not shown, was never evaluated: core/one.hpp:5:7: n > 2' '4, 3, 0' '0, 0, 0'
judge 'a listed one is shown' 1 'listed as unreachable, but shown: core/one.hpp:2:10: a' '"' '"' 'one.hpp | a | why'
judge 'a listed one is no condition' 1 'listed as unreachable, but no condition that is not shown: one.hpp | c' \
  '"' '"' 'one.hpp | c | why'
judge 'a nested decision' 1 'not analysed, because decisions are nested: core/one.hpp:2:15: b' \
  '1, 2, 0, 0, 6' '1, 2, 0, 0, 4'
echo 'inline int other(int n) { return n > 0 ? n : 0; }' >core/two.hpp
judge 'a file that no test compiles' 1 'in no test: core/two.hpp' '"' '"'
echo '// if it decided' >core/two.hpp
judge 'a file that decides nothing' 0 "$all" '"' '"'
((failures == 0)) || exit 1
echo "conditions that are not shown, listed wrongly, not analysed or in no test are found"
