#!/usr/bin/env bash
# rate_table_in_chamber.sh FOGCOMP: a gyro on a rate table whose scale factor follows the temperature of its light
# source, 150 s behind the coil's, to second order; the table steps at 100 deg/s^2, and its record is 150 ms late. The
# flanks are left out and the delay is said; each part of the formula is refused for what the others leave, and the loop
# finds them all. (Made here, not by the simulator: its tables step between two samples.)
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: rate_table_in_chamber.sh FOGCOMP}")
enter_scratch

# gyro NAME SEED RATES TEMPERATURES: 10 Hz; RATES: deg/s:seconds, again and again; TEMPERATURES: degC:hours, ramps.
gyro() {
  random_awk -v seed="$2" -v rates="$3" -v temperatures="$4" '
    BEGIN {
      seed_draws(seed)
      print "time_s,temperature_degc,rate_dph,input_rate_dph"
      holds = split(rates, rate, " "); ramps = split(temperatures, ramp, " ")
      degc = coil = source = 22; fine = 0.01; late = 15
      for (r = 1; r <= ramps; ++r) {
        split(ramp[r], to, ":")
        slope = (to[1] - degc) / (to[2] * 3600)
        for (s = 0; s < to[2] * 36000; ++s) {
          degc += slope * 0.1
          coil += (degc - coil) / 3000
          source += (coil - source) / 1500
          moved = recorded = 0
          for (i = 0; i < 10; ++i) {
            if (n * fine >= until) { split(rate[1 + hold++ % holds], one, ":"); until += one[2] }
            step = one[1] - w
            w += step > 1 ? 1 : step < -1 ? -1 : step
            recorded += past[n % late] / 10
            past[n % late] = w
            moved += w / 10
            ++n
          }
          k = source - 20
          drift = 0.5 + 0.004 * (coil - 20) + moved * 3600e-6 * (80 + 15 * k + 0.3 * k * k)
          printf "%.1f,%.4f,%.4f,%.4f\n", ++row / 10, 0.0625 * int((coil + 0.02 * normal()) / 0.0625 + 100.5) - 6.25,
            3600 * moved + drift + 0.95 * normal(), 3600 * recorded
        }
      }
    }' >"$1.csv"
}
gyro up 1 "50:31.7 0:17.3 -50:29.1 120:23.3 0:11.9 -120:23.9" "22:0.3 60:0.8 -30:1.5 25:1.2"
gyro down 2 "-84:27 0:13.4 84:26.3 -35:32.9 0:19.5 35:35.8" "22:0.3 -30:0.9 60:1.6"

"$fogcomp" fit up.csv -o gyro.model --effects bias,bias_temperature:order=2,temperature_rate >/dev/null 2>said.txt
cat said.txt
says said.txt 'at 5[0-9][0-9] changes, which it shows 15[0-9].* ms later than the gyro'
"$fogcomp" diagnose gyro.model up.csv --max-effects 8 -o end.model >ladder.txt
sed -n '/^Error ladder/,/the end/p' ladder.txt
says ladder.txt '\+ scale_factor_temperature:order=2'
says ladder.txt '\+ scale_factor_temperature:(order=3,)?lag=\? \(a refinement\)'
"$fogcomp" compare end.model down.csv --json >compare.json
echo "another programme: $(value compare.json '.runs[0].residual_rms_dph') deg/h"
holds compare.json '.runs[0].residual_rms_dph < 1.5'
