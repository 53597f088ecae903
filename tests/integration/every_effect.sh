#!/usr/bin/env bash
# every_effect.sh FOGCOMP: each effect of the catalogue can be fitted to a recording that has its inputs, printed,
# compared, and exported within the quantisation limit (without what no board can have); a recording whose time begins
# late gives a warm-up of the same size; a jump of the bias is found and cut, in a holdout, too.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: every_effect.sh FOGCOMP}")
enter_scratch

"$fogcomp" simulate -o cycle.csv --columns all --latitude 34 >/dev/null
"$fogcomp" simulate -o field.csv --seed 2 --profile field_and_vibration --columns all --latitude 34 >/dev/null
"$fogcomp" simulate -o table.csv --seed 3 --profile rate_table --columns all --latitude 34 >/dev/null

refused=
count=0
for effect in $("$fogcomp" effects | awk '/^[a-z0-9_]+ - / { print $1 }'); do
  "$fogcomp" effects "$effect" >entry.txt
  list=$effect
  [[ $effect == bias ]] || list=bias,$list
  # Field, vibration and input rate stand still in a chamber cycle.
  "$fogcomp" fit cycle.csv field.csv table.csv -o one.model --effects "$list" >fit.txt
  grep -q "^  $effect " fit.txt || fail "$effect is not in the printed model: $(cat fit.txt)"
  "$fogcomp" compare one.model cycle.csv >/dev/null
  allowed=()
  if grep -q '^  export     refuses it' entry.txt; then
    status=0
    "$fogcomp" export one.model -o refused.h --extension 2>export.txt || status=$?
    ((status == 2)) && grep -q "^one.model: effect '$effect' goes on while the power is off" export.txt &&
      [[ ! -e refused.h ]] ||
      fail "$effect: exit code $status: $(cat export.txt)"
    allowed=(--allow-error)
    refused+=" $effect"
  fi
  "$fogcomp" export one.model -o fog_model.h --extension "${allowed[@]}" >export.txt || fail "$effect: $(cat export.txt)"
  if grep -q '^  host only' entry.txt; then
    says export.txt "^note: $effect is left out: "
    says fog_model.h "define FOG_MODEL_EFFECTS 0x1u"
  fi
  count=$((count + 1))
done
((count > 0)) || fail "no effect in the list of effects"

# The same warm-up in a recording that begins an hour late: the amplitude is that at power-on, not at its first row.
{
  echo "time_s,temperature_degc,rate_dph"
  random_awk 'BEGIN {
    seed_draws(1)
    for (t = 0; t < 43200; t += 10) print t ",20," 1 + 5 * exp(-t / 3600) + 0.05 * (uniform() - 0.5)
  }'
} >warm.csv
awk -F, 'NR == 1 || $1 >= 3600' warm.csv >late.csv
amplitude() {
  "$fogcomp" fit "$1" -o warm.model --effects bias,warm_up:tau=3600 | awk '$1 == "A" { print $3 }'
}
early=$(amplitude warm.csv) late=$(amplitude late.csv)
awk -v early="$early" -v late="$late" 'BEGIN { exit !(early > 4.95 && early < 5.05 && late > 4.95 && late < 5.05) }' ||
  fail "a warm-up of 5 deg/h became $early, and $late in a recording that begins late"
# A jump of the bias is found, proposed as a cut, judged and made; the model's bias is that after it.
awk -F, -v OFS=, '/^[0-9]/ && $1 >= 26000 { $3 += 0.3 } { print }' warm.csv >step.csv
"$fogcomp" fit step.csv -o stepless.model --effects bias,warm_up:tau=3600 >/dev/null
"$fogcomp" diagnose stepless.model step.csv --json >step.json
jq -e '.effect == "bias_step" and (.next | test("^fogcomp add stepless.model step.csv --cut (259|260)[0-9]{2} -o"))' \
  step.json >/dev/null || fail "the jump at 26000 s: $(jq -c '{verdict, effect, next}' step.json)"
next=$(jq -r .next step.json)
eval "\"$fogcomp\" ${next#fogcomp }" >added.txt
says added.txt '^accepted: '
says added.txt '^  bias 2 lies \+0\.(29|30|31)[0-9]* deg/h from the first$'
"$fogcomp" diagnose stepless.model step.csv --max-effects 1 -o ladder.model >ladder.txt
says ladder.txt '^  \+ a jump of the bias at (259|260)[0-9]{2} s '
bias_of() { awk '$1 == "effect" { bias = $2 == "bias" } bias && $1 == "on_board" { print $2; bias = 0 }' "$1"; }
difference() { awk -v a="$(bias_of "$1")" -v b="$(bias_of "$2")" 'BEGIN { print a - b }'; }
"$fogcomp" fit warm.csv -o plain.model --effects bias,warm_up:tau=3600 >/dev/null
for made in NEW.model ladder.model; do
  awk -v d="$(difference "$made" plain.model)" 'BEGIN { exit !(d > 0.28 && d < 0.32) }' ||
    fail "$made has not the bias after the jump: $(difference "$made" plain.model) above that before"
done
# Added by hand or by the loop it is the same model, with masks, too.
same_bytes ladder.model NEW.model
masked=(--mask 100..900 --mask step.csv:30000..30500)
"$fogcomp" diagnose stepless.model step.csv "${masked[@]}" --max-effects 1 -o ladder.model --json >masked.json
mv ladder.model by_loop.model
next=$(jq -r .commands[0] masked.json)
eval "\"$fogcomp\" ${next#fogcomp }" >added.txt
same_bytes by_loop.model ladder.model
# The next command has the holdouts whose cuts it repeats, and no cut that was refused.
next_of() { in_full <"$1" | sed -n 's/^  next: fogcomp //p'; }
"$fogcomp" add plain.model warm.csv --cut 12000 -o refused.model >added.txt && fail "a jump that is not there is accepted"
says added.txt '^  next: fogcomp diagnose plain.model warm.csv$'
"$fogcomp" add NEW.model step.csv --cut "$(sed -n 's/.*add --cut //p' NEW.model)" --cut 12000 -o refused.model >added.txt &&
  fail "a jump that is not there is accepted beside one that is"
says added.txt '^  next: fogcomp diagnose NEW.model step.csv --cut (259|260)[0-9]{2}$'
"$fogcomp" simulate -o ramp.csv >/dev/null
"$fogcomp" fit ramp.csv -o bias.model --effects bias >/dev/null
holdout=(--holdout step.csv --cut step.csv:26000)
"$fogcomp" add bias.model temperature_rate ramp.csv "${holdout[@]}" --force -o kept.model >added.txt
says added.txt "^  next: fogcomp diagnose kept.model ramp.csv ${holdout[*]}$"
next=$(next_of added.txt)
eval "\"$fogcomp\" $next" >/dev/null || fail "refused: $next"
# What the model lacks in a ramp is no jump.
"$fogcomp" diagnose bias.model ramp.csv --json >ramp.json
jq -e '.effect != "bias_step"' ramp.json >/dev/null || fail "a ramp is taken for a jump"
# Nothing holds on a holdout whose bias jumps: the jump is found there, and a cut of it judges.
"$fogcomp" simulate -o run.csv --seed 5 >/dev/null
"$fogcomp" simulate -o other.csv --seed 6 --profile reversed >/dev/null
awk -F, -v OFS=, '/^[0-9]/ && $1 >= 30000 { $3 += 0.3 } { print }' other.csv >jump.csv
"$fogcomp" fit run.csv -o cubic.model --effects bias,bias_temperature:order=3 >/dev/null
"$fogcomp" diagnose cubic.model run.csv --holdout jump.csv --max-effects 1 -o loop.model --json >jump.json
jq -e '.commands[0] | test(" --holdout jump.csv --cut jump.csv:(2999|3000)[0-9] ")' jump.json >/dev/null ||
  fail "the jump of the holdout: $(jq -c '{verdict, commands}' jump.json)"
mv loop.model by_loop.model
while read -r next; do
  eval "\"$fogcomp\" ${next#fogcomp }" >added.txt
  says added.txt '^accepted: '
done < <(jq -r '.commands[]' jump.json)
same_bytes by_loop.model loop.model
[[ $refused == " aging" ]] || fail "export refuses$refused"
echo "$count effects fitted, printed, compared and exported; warm-up $early deg/h, begun late $late deg/h"
