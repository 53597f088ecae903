#!/usr/bin/env bash
# denoise_worth.sh FOGCOMP: on the simulated run of the reference paper with outliers added, offline
# denoising brings the error against the noise-free truth to at most 0.35 of the noise in soaks and 0.5
# in ramps, keeps the mean to 1e-5 deg/h, and leaves no outlier. Prints the segments beside the paper's.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: denoise_worth.sh FOGCOMP}")
enter_scratch

"$fogcomp" simulate -o run.csv --profile paper --hide truth.csv >/dev/null
# Twenty outliers of 0.4 to 0.8 deg/h: 16 to 33 standard deviations of the noise.
awk -F, -v OFS=, '!/^#/ && ++n > 1 && n % 290 == 17 { $3 += (n % 580 == 17 ? 1 : -1) * (0.4 + n % 5 / 10) }
  { print }' run.csv >spiked.csv
spikes=$(diff run.csv spiked.csv | grep -c '^>') || true # diff says 1: they differ
((spikes >= 20)) || fail "$spikes outliers"
"$fogcomp" denoise spiked.csv -o soft.csv >report.txt
"$fogcomp" denoise spiked.csv -o hard.csv --mode hard >/dev/null
"$fogcomp" denoise run.csv -o clean.csv >/dev/null
cat report.txt

# Errors against the truth, by the chamber's programme: a ramp is where the coil moves by more than
# 0.1 degC a minute.
awk -F, -v spikes="$spikes" '
  /^#/ { next }
  FILENAME == "truth.csv" {
    if ($1 == "time_s") { for (i = 1; i <= NF; i++) if ($i ~ /_dph$/ && $i !~ /^(noise|input)/) drift[i] = 1
                          for (i = 1; i <= NF; i++) if ($i ~ /^noise_.*_dph$/) noise[i] = 1
                          next }
    for (i in drift) truth[$1 + 0] += $i
    for (i in noise) white[$1 + 0] += $i
    coil[$1 + 0] = $2
    next
  }
  $1 == "time_s" { next }
  {
    t = $1 + 0
    kind = (t >= 60 && (coil[t] - coil[t - 60]) ^ 2 > 0.01) ? "ramp" : "soak"
    error = $3 - truth[t]
    n[kind, FILENAME]++
    square[kind, FILENAME] += error ^ 2
    raw[kind, FILENAME] += white[t] ^ 2
    if (error ^ 2 > worst[FILENAME] ^ 2) worst[FILENAME] = error
    sum[FILENAME] += $3
    rows[FILENAME]++
  }
  END {
    printf "\n%-26s %10s %10s %10s\n", "error / noise", "soaks", "ramps", "largest"
    for (f = 1; f <= 3; f++) {
      name = f == 1 ? "clean.csv" : f == 2 ? "soft.csv" : "hard.csv"
      for (k = 1; k <= 2; k++) {
        kind = k == 1 ? "soak" : "ramp"
        ratio[name, kind] = sqrt(square[kind, name] / raw[kind, name])
      }
      printf "%-26s %10.3f %10.3f %10.4f deg/h\n", name == "clean.csv" ? "soft, without outliers" : \
        name == "soft.csv" ? "soft, " spikes " outliers" : "hard, " spikes " outliers",
        ratio[name, "soak"], ratio[name, "ramp"], worst[name]
    }
    mean_change = sum["clean.csv"] / rows["clean.csv"] - sum["run.csv"] / rows["run.csv"]
    printf "mean of the whole run changed by %.7f deg/h\n", mean_change
    ok = ratio["soft.csv", "soak"] <= 0.35 && ratio["soft.csv", "ramp"] <= 0.5 &&
         mean_change ^ 2 <= 1e-10 && worst["soft.csv"] ^ 2 < 0.1 ^ 2
    exit !ok
  }' truth.csv run.csv clean.csv soft.csv hard.csv
