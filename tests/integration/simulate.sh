#!/usr/bin/env bash
# simulate.sh FOGCOMP: the same words give the same bytes, a hidden truth stays hidden, and every ready-made
# profile and preset that --list names can be run.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: simulate.sh FOGCOMP}")
enter_scratch

hidden=(--profile random_steps --seed 5 --effect glass_transition:peak=0.05,tg_degc=22)
"$fogcomp" simulate -o open.csv "${hidden[@]}" >/dev/null
"$fogcomp" simulate -o closed.csv "${hidden[@]}" --hide truth.csv --json >said.json
cmp open.csv closed.csv
! grep -il glass closed.csv said.json || fail "the hidden effect shows"
says truth.csv '^# effect glass_transition: peak=0.05 scale=1 tg_degc=22 '
(($(grep -c '^[0-9]' truth.csv) == $(grep -c '^[0-9]' closed.csv))) || fail "the truth has other rows than the recording"

for format in csv stream; do
  "$fogcomp" simulate -o first --format $format --rate 2 --seed 3 >/dev/null
  "$fogcomp" simulate -o second --format $format --rate 2 --seed 3 >/dev/null
  cmp first second
  "$fogcomp" simulate -o third --format $format --rate 2 --seed 4 >/dev/null
  ! cmp -s first third || fail "$format: the seed changes nothing"
done
(($(stat -c %s first) == 59550 * 2 * 16)) || fail "a stream of $(stat -c %s first) bytes"

names() {  # names TITLE: the words that --list shows under a title
  "$fogcomp" simulate --list | awk -v title="$1" '$1 == title { on = 1; next } !NF { on = 0 } on { print $1 }'
}
for profile in $(names profiles); do
  "$fogcomp" simulate -o run.csv --profile "$profile" --columns all --latitude 34 >/dev/null
done
for preset in $(names presets) none; do "$fogcomp" simulate -o run.csv --preset "$preset" >/dev/null; done
(($(names profiles | wc -l) >= 7 && $(names presets | wc -l) == 3)) || fail "--list: $("$fogcomp" simulate --list)"
echo "simulate: same seed same bytes, truth hidden, $(names profiles | wc -l) profiles run"
