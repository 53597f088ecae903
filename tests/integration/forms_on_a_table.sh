#!/usr/bin/env bash
# forms_on_a_table.sh FOGCOMP: two gyros on a rate table in a chamber, with what no catalogue has: of one the scale
# factor settles after power-on, of the other its asymmetry follows the temperature. A table that steps makes cycles of
# both; the loop finds the formulas, and they hold in another programme. (Made here, not by the simulator.)
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: forms_on_a_table.sh FOGCOMP}")
enter_scratch

# gyro NAME SEED RATES TEMPERATURES SETTLING ASYMMETRY: 1 Hz; RATES: deg/s, 60 s each, again and again; TEMPERATURES:
# degC:hours, ramps; ppm at power-on, ppm/K.
gyro() {
  random_awk -v seed="$2" -v rates="$3" -v temperatures="$4" -v settling="$5" -v asymmetry="$6" '
    BEGIN {
      seed_draws(seed)
      print "time_s,temperature_degc,rate_dph,input_rate_dph"
      holds = split(rates, rate, " "); ramps = split(temperatures, ramp, " ")
      degc = coil = 20
      for (r = 1; r <= ramps; ++r) {
        split(ramp[r], to, ":")
        slope = (to[1] - degc) / (to[2] * 3600)
        for (s = 0; s < to[2] * 3600; ++s) {
          degc += slope
          coil += (degc - coil) / 300
          w = 3600 * rate[1 + int(n / 60) % holds]
          drift = 0.5 + 0.003 * (coil - 20) + 1e-6 * (settling * exp(-n / 2500) * w + \
            asymmetry * (coil - 20) * (w < 0 ? -w : w))
          printf "%d,%.4f,%.4f,%.4f\n", n, coil + 0.02 * normal(), w + drift + 0.6 * normal(), w
          ++n
        }
      }
    }' >"$1.csv"
}

# found NAME FORM: the loop on NAME.csv ends with FORM, and at the noise in NAME_other.csv.
found() {
  "$fogcomp" fit "$1.csv" -o gyro.model --effects bias,bias_temperature >/dev/null
  "$fogcomp" diagnose gyro.model "$1.csv" --max-effects 4 -o end.model >ladder.txt || fail "$(cat ladder.txt)"
  sed -n '/^Error ladder/,/the end/p' ladder.txt
  grep -qF -- "$2" ladder.txt || fail "$1: $2 is not in $(cat ladder.txt)"
  "$fogcomp" compare end.model "$1_other.csv" --json >compare.json
  echo "$1, another programme: $(value compare.json '.runs[0].residual_rms_dph') deg/h"
  holds compare.json '.runs[0].residual_rms_dph < 1.2 * 0.6 / (10 | sqrt)'
}

rates="0 20 -20 10 0 -10" other_rates="-15 0 15 -5 18" degc="20:0.4 50:1.2 -30:2 20:0.9" other_degc="20:0.2 -25:1 45:1.5"
gyro settling 1 "$rates" "$degc" 30 0
gyro settling_other 2 "$other_rates" "$other_degc" 30 0
gyro one_sided 3 "$rates" "$degc" 0 0.3
gyro one_sided_other 4 "$other_rates" "$other_degc" 0 0.3
found settling 'W*exp(-t/'
found one_sided '*abs(W)'
