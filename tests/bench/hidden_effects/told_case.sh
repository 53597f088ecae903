#!/usr/bin/env bash
# told_case.sh FOGCOMP DIR KEY ID: what a model that is told all hidden effects leaves of a case's unseen run:
# DIR/answers/ID/told.json, as `fogcomp compare` says it. No loop can be expected to do better. Skipped if the
# case was answered by the same tool.
set -euo pipefail
fogcomp=$1 plan=$2/truth/$4/plan.txt runs=$2/runs/$4 answers=$2/answers/$4
[[ -f $runs/unseen.csv ]] || exit 0
key="$3 $(cksum <"$plan")"
[[ -f $answers/told.key && $(<"$answers/told.key") == "$key" ]] && exit 0
effects=$(sed -n 's/^declared //p' "$plan")
while read -r hidden; do
  if [[ $hidden == bias_temperature ]]; then # the order above the declared one, which is 2 if none is said
    order=$(sed -nE 's/.*bias_temperature:order=([0-9]).*/\1/p' <<<"$effects")
    effects=$(sed -E 's/bias_temperature(:order=[0-9])?/bias_temperature:order='"$((${order:-2} + 1))/" <<<"$effects")
  else
    effects+=,$hidden
  fi
done < <(sed -nE 's/^hidden ([a-z_]+) .*/\1/p' "$plan")
rm -f "$answers"/told.*
if "$fogcomp" fit "$runs"/run*.csv -o "$answers/told.model" --effects "$effects" >"$answers/told.out" 2>&1; then
  "$fogcomp" compare "$answers/told.model" "$runs/unseen.csv" --json >"$answers/told.json"
fi
echo "$key" >"$answers/told.key"
