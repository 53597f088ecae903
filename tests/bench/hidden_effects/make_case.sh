#!/usr/bin/env bash
# make_case.sh FOGCOMP PROGRAMMES DIR KEY ID: makes the recordings of one case in DIR/runs/ID, the truth in
# DIR/truth/ID. Skipped if DIR/truth/ID/key is KEY. The truth's rows are large and only its facts are needed: KEEP=1
# keeps them.
set -euo pipefail
fogcomp=$1 programmes=$2 key=$4 id=$5
runs=$3/runs/$id truth=$3/truth/$id
[[ -f $truth/key && $(<"$truth/key") == "$key" && ${KEEP:-0} == 0 ]] && exit 0
rm -rf "$runs" "$truth"
mkdir -p "$runs" "$truth"
"$programmes/plan_case" "$id" "$runs" "$truth"
while read -r name arguments; do
  read -ra words <<<"$arguments"
  "$fogcomp" simulate -o "$runs/$name.csv" --hide "$truth/$name.csv" "${words[@]}" >"$truth/said.txt"
done <"$truth/simulate.txt"
"$programmes/case_facts" "$runs" "$truth"
# form_likeness needs the rows, too.
((${KEEP:-0})) || grep -q '^kind form$' "$truth/plan.txt" || rm "$truth"/*.csv
echo "$key" >"$truth/key"
