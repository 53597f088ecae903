#!/usr/bin/env bash
# several_axes.sh FOGCOMP: one call fits the three axes of a file, shows them in one table and on one page, and one
# applies the three models.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: several_axes.sh FOGCOMP}")
enter_scratch
random_awk 'BEGIN {
  seed_draws(1)
  print "time_s,temperature_degc,Gyro_X [deg/h],Gyro_Y [deg/h],Gyro_Z [deg/h]"
  for (i = 0; i < 1500; i++) {
    T = i < 750 ? 20 + i / 25 : 80 - i / 25
    printf "%d,%.3f,%.4f,%.4f,%.4f\n", 10 * i, T, 1 + 0.1 * T + normal() / 10, 2 - 0.2 * T + normal() / 10, 3 + normal() / 10
  }
}' >imu.csv
axes=(--rate-column Gyro_X,Gyro_Y,Gyro_Z)
"$fogcomp" fit imu.csv "${axes[@]}" -o '%.model' --effects bias,bias_temperature --report imu.html >fit.txt 2>said.txt
says fit.txt '^3 axes$'
for axis in X Y Z; do
  [[ -s Gyro_$axis.model ]] || fail "no model of axis $axis"
  says fit.txt "^ *Gyro_$axis +the model leaves .* deg/h rms"
  grep -q "Gyro_$axis" imu.html || fail "axis $axis is not on the page"
done
[[ $(grep -c '^report: imu.html' said.txt) == 1 ]] || fail "not one page: $(cat said.txt)"
"$fogcomp" compare '%.model' imu.csv "${axes[@]}" --report of_%.html >compare.txt 2>said.txt
says compare.txt '^3 axes$'
ls of_Gyro_X.html of_Gyro_Y.html of_Gyro_Z.html >/dev/null
"$fogcomp" apply '%.model' imu.csv "${axes[@]}" -o 'out_%.csv' >said.txt 2>&1
for axis in X Y Z; do
  awk -F, -v axis="$axis" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
    { c = $(at["compensated_dph"]); n++; s += c; q += c * c }
    END { exit !(n == 1500 && sqrt(q / n - s * s / n / n) < 0.12) }' "out_Gyro_$axis.csv" ||
    fail "axis $axis is not compensated: $(head -n 3 "out_Gyro_$axis.csv")"
done
status=0
"$fogcomp" fit imu.csv "${axes[@]}" -o one.model --effects bias >said.txt 2>&1 || status=$?
[[ $status == 2 ]] || fail "three models in one file: exit code $status"
says said.txt 'put % where its name belongs'
