#!/usr/bin/env bash
# own_candidate.sh FOGCOMP: something is hidden that the catalogue does not have. diagnose calls it unknown, finds its
# form, and names an expression that is offered and describes it; the command that it proposes adds that, the error
# falls on a run that was held out, and nothing of it is left to be found.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: own_candidate.sh FOGCOMP}")
enter_scratch

# Strain that follows the square of the temperature rate, behind two masses: in the simulator alone.
hidden=squared_lag:scale=3
parts="--effect $hidden --effect polarization_ripple:second=0" # one ripple, which the model then describes in full
"$fogcomp" simulate -o run.csv --seed 4 $parts >/dev/null
"$fogcomp" simulate -o second.csv --seed 5 --profile reversed $parts >/dev/null
known=bias,bias_temperature,temperature_rate,temperature_rate_product,polarization_ripple,warm_up
"$fogcomp" fit run.csv -o gyro.model --effects $known >/dev/null

"$fogcomp" diagnose gyro.model run.csv --details | in_full >alone.txt
says alone.txt '^something is missing(:| that no effect of the catalogue explains)'
# It finds the form by itself, says that this is no cause, and proposes what `add` accepts.
grep -qF 'it looks like lag(lag(dTdt,tau),tau)^2' alone.txt || fail "the form: $(cat alone.txt)"
grep -q 'this describes it, it does not say what it is' alone.txt || fail "a description: $(cat alone.txt)"
eval "\"$fogcomp\" $(sed -n 's/^  next: fogcomp //p' alone.txt)" >described.txt || fail "refused: $(cat described.txt)"
"$fogcomp" diagnose gyro.model run.csv --json >alone.json
holds alone.json '.forms[0].name == "lag(lag(dTdt,tau),tau)^2"'

# What does not describe it is not named.
"$fogcomp" diagnose gyro.model run.csv --effect-expr 'burst = T*T*dTdt' >wrong.txt
grep -qE '^something is missing(:| that no effect .* and no expression offered explains)' wrong.txt ||
  fail "$(cat wrong.txt)"

stress='stress = lag(dTdt^2, ?tau[60,3000])'
"$fogcomp" diagnose gyro.model run.csv --effect-expr 'burst = T*T*dTdt' --effect-expr "$stress" >named.txt
head -n 6 named.txt
grep -qF 'missing effect: stress (lag(dTdt^2, ?tau[60,3000]))' named.txt || fail "$(cat named.txt)"
"$fogcomp" diagnose gyro.model run.csv --effect-expr "$stress" --json >named.json
holds named.json '.verdict == "missing_effect" and .effect == "stress" and .candidates[0].effect == "stress"'
holds named.json '.candidates[0].parameters.tau | 1000 < . and . < 2200'
holds named.json '.candidates[0].parameters.k | 0.2 < . and . < 0.5'

# The command that it says, as it says it.
next=$(sed -n 's/^  next: fogcomp //p' named.txt)
[[ $next == "add gyro.model run.csv --effect-expr '$stress' -o NEW.model" ]] || fail "next: $next"
eval "\"\$fogcomp\" $next --holdout second.csv --json" >add.json
holds add.json '.accepted and .effect == "stress"'
value add.json '.runs[1] | "held out: \(.rms_before_dph) -> \(.rms_after_dph) deg/h rms"'
holds add.json '.runs[1].rms_after_dph < 0.8 * .runs[1].rms_before_dph'
holds add.json '.parameters.tau | 1200 < . and . < 2000'
"$fogcomp" history NEW.model --json >history.json
holds history.json ".steps[1].action == \"add $stress\""
says NEW.model '^expression stress '

# A model with an expression in it is diagnosed like any other.
"$fogcomp" diagnose NEW.model second.csv --json >again.json
holds again.json '.verdict == "none"'

# Two things missing: the ladder takes the catalogue's and the expression.
"$fogcomp" fit run.csv -o less.model --effects ${known/,temperature_rate,/,} >/dev/null
"$fogcomp" diagnose less.model run.csv --max-effects 4 --effect-expr "$stress" >ladder.txt
sed -n '/^error ladder/,$p' ladder.txt
grep -q '^  + temperature_rate' ladder.txt && grep -q '^  + stress' ladder.txt || fail "$(cat ladder.txt)"

# What this gyro does not have is refused, exit code 1, unless forced.
status=0
"$fogcomp" add NEW.model run.csv --effect-expr 'wave = sin(T / 2)' -o wave.model >refused.txt || status=$?
[[ $status == 1 && ! -e wave.model ]] || fail "$(cat refused.txt)"
grep -q '^refused: does not help out of sample' refused.txt || fail "$(cat refused.txt)"
"$fogcomp" add NEW.model run.csv --effect-expr 'wave = sin(T / 2)' -o wave.model --force >forced.txt
grep -q '^written by --force: wave.model' forced.txt || fail "$(cat forced.txt)"
