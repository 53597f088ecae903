#!/usr/bin/env bash
# one_temperature_each.sh FOGCOMP: recordings at one chamber temperature each. What the gyro does with temperature lies
# between them, where biases that change from power-on to power-on lie too: the loop finds it, and says what is unsure.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: one_temperature_each.sh FOGCOMP}")
enter_scratch

# record FILE DEGC BIAS: half an hour at 1 Hz, of 5 deg/h, that bias, and a parabola of the temperature.
seed=1
record() {
  random_awk -v soak="$2" -v bias="$3" -v seed="$((seed++))" '
    BEGIN {
      seed_draws(seed)
      print "time_s,temperature_degc,rate_dph"
      for (t = 0; t < 1800; ++t) {
        degc = soak + 0.3 * (1 - exp(-t / 900))
        drift = 5 + bias + 0.02 * (degc - 20) - 2e-4 * (degc - 20) ^ 2
        printf "%d,%.3f,%.4f\n", t, degc + 0.005 * normal(), drift + 0.3 * normal()
      }
    }' >"$1"
}
temperatures=(-40 -20 0 20 40 60)
biases=(0.1 -0.2 0.15 -0.05 0.2 -0.1 -0.12 0.08 0.2 -0.15 0.03 0.07)
for i in {0..5}; do
  record "same$i.csv" "${temperatures[i]}" 0
  record "once$i.csv" "${temperatures[i]}" "${biases[i]}"
  record "twice$i.csv" "${temperatures[i]}" "${biases[i + 6]}"
done
record unseen.csv 10 0

# Equal biases: by the loop, and by the command that it prints.
"$fogcomp" fit same?.csv -o bias.model --effects bias >said.txt
says said.txt 'a drift that it lacks' "fit of the bias alone"
"$fogcomp" diagnose bias.model same?.csv --max-effects 4 -o loop.model --details >said.txt || fail "ended: $(cat said.txt)"
says said.txt 'bias_temperature shows between the recordings' "the loop"
"$fogcomp" diagnose bias.model same?.csv --details >said.txt || true
next=$(sed -n 's/^  next: fogcomp //p' said.txt)
[[ $next == 'add bias.model bias_temperature '* ]] || fail "next: $next"
# shellcheck disable=SC2086
"$fogcomp" ${next/NEW.model/typed.model} >said.txt || fail "refused: $(cat said.txt)"
for model in loop typed; do
  "$fogcomp" compare $model.model unseen.csv --json >compare.json
  holds compare.json '.runs[0].residual_rms_dph < 0.11' # the noise is 0.095
done

# Biases of their own, each temperature once: a drift and these cannot be told apart.
"$fogcomp" fit once?.csv -o once.model --effects bias,bias_temperature:order=2 >fitted.txt
"$fogcomp" compare once.model once?.csv >compared.txt
"$fogcomp" diagnose once.model once?.csv --details >diagnosed.txt || true
for said in fitted compared diagnosed; do
  says $said.txt 'each temperature in two of the recordings, or one recording over all of them, would tell'
  if grep -q 'turn-on bias: ' $said.txt; then fail "a drift is taken for a bias: $(cat $said.txt)"; fi
done

# Each temperature twice: they can. The drift is then found between the recordings, as well as the biases allow.
"$fogcomp" fit once?.csv twice?.csv -o both.model --effects bias,bias_temperature:order=2 >said.txt
says said.txt 'turn-on bias: ' "each temperature twice"
"$fogcomp" fit once?.csv twice?.csv -o both.model --effects bias,bias_temperature:order=2 --json >fit.json
holds fit.json '0.09 < .turn_on_repeatability.sigma_dph and .turn_on_repeatability.sigma_dph < 0.21' # 0.14 here
slope=$(sed -n 's/^ *b1 *= *\([-0-9.e]*\).*/\1/p' said.txt)
awk -v slope="$slope" 'BEGIN { exit !(0.014 < slope && slope < 0.026) }' || fail "slope $slope, not 0.02 deg/h/degC"
