#!/usr/bin/env bash
# simulate_gyros.sh FOGCOMP N DIR: a simulated production lot for `fogcomp batch`: N gyros of the preset `paper`, each
# with its own noise and coefficients, a run of the paper's programme for the fit and its reverse as holdout, one row
# per 10 s. Gyro 3 of every hundred has an effect that the fitted effects cannot describe.
set -euo pipefail
fogcomp=${1:?usage: simulate_gyros.sh FOGCOMP N DIR} count=$2 parent=$3

# coefficients SEED: --effect options, spread about the preset's like a lot of coils.
coefficients() {
  LC_ALL=C awk -v seed="$1" 'function spread(mean, share) { return mean * (1 + share * (2 * rand() - 1)) }
    BEGIN {
      srand(seed)
      printf "--effect bias:value_dph=%.4f ", spread(0.73, 0.5)
      printf "--effect bias_temperature:slope=%.4g,curvature=%.4g ", spread(-4.3e-4, 0.5), spread(-3.6e-5, 0.3)
      printf "--effect temperature_rate:coefficient=%.4f ", spread(0.137, 0.3)
      printf "--effect polarization_ripple:amplitude_dph=%.4f,period_k=%.1f,phase_deg=%.0f ", \
        spread(0.03, 0.5), spread(40, 0.2), 360 * rand()
      if (seed % 100 == 3) printf "--effect thermal_hysteresis:width_dph=0.1 "
    }'
}

for ((i = 1; i <= count; ++i)); do
  folder=$parent/$(printf 'G%03d' "$i")
  mkdir -p "$folder"
  read -ra options <<<"$(coefficients "$i")"
  "$fogcomp" simulate -o "$folder/run.csv" --seed $((2 * i)) "${options[@]}" >"$folder/simulated.txt"
  "$fogcomp" simulate -o "$folder/holdout.csv" --profile reversed --seed $((2 * i + 1)) "${options[@]}" \
    >>"$folder/simulated.txt"
done
