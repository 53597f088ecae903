#!/usr/bin/env bash
# next_steps.sh [COUNT] [BUILD]: runs the commands proposed by `diagnose`, as printed, until there is no proposal: on
# COUNT simulated gyros (60) of every preset on every programme, starting with bias and bias_temperature. Prints how
# many proposals `add` accepted, and the final sentences. Exit code 1 if one was refused.
set -euo pipefail
count=${1:-60}
fogcomp=$(realpath "${2:-$(dirname "$0")/../../build/host}/fogcomp")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

presets=(paper tactical navigation)
profiles=(paper reversed ramp_rates random_steps minor_loops long_soak power_cycles rate_table)
typed=0 accepted=0
for ((i = 0; i < count; i++)); do
  preset=${presets[i % 3]} profile=${profiles[i / 3 % 8]}
  "$fogcomp" simulate -o run.csv --preset "$preset" --profile "$profile" --seed $((7000 + i)) >/dev/null
  "$fogcomp" fit run.csv -o gyro.model --effects bias,bias_temperature >/dev/null
  for ((step = 0; step < 9; step++)); do
    "$fogcomp" diagnose gyro.model run.csv >found.txt
    next=$(sed -n 's/^  next: fogcomp add //p' found.txt)
    [[ -n $next ]] || break
    typed=$((typed + 1))
    if eval "\"\$fogcomp\" add ${next/NEW.model/new.model}" >added.txt 2>&1; then
      accepted=$((accepted + 1))
      mv new.model gyro.model
    else
      echo "refused: seed $((7000 + i)), $preset on $profile: add $next: $(head -n 1 added.txt)"
      break
    fi
  done
  head -n 1 found.txt | sed -E 's/ \([0-9]+ %.*//; s/: .*//' >>ends.txt
done
echo "$count loops: $accepted of $typed proposals accepted; they ended with"
sort ends.txt | uniq -c | sort -rn
((accepted == typed))
