#!/usr/bin/env bash
# propose_case.sh FOGCOMP DIR KEY ID: for an ambiguous answer with a proposed experiment, two more cases of the same
# gyro: DIR/runs/ID.proposed with a run of the proposed programme, DIR/runs/ID.random with a random one (seeded by the
# case's name). For cases with one catalogued effect; no experiment repeats a step.
set -euo pipefail
fogcomp=$1 folder=$2 key=$3 id=$4
runs=$folder/runs/$id truth=$folder/truth/$id
said=$folder/answers/$id/diagnosis.json
proposed=
if grep -q '^kind single$' "$truth/plan.txt" && ! grep -q '^hidden bias_step ' "$truth/plan.txt" && [[ -f $said ]]; then
  proposed=$(sed -nE '/"verdict":"ambiguous"/ s/.*"experiment_profile":"([a-z_]+)".*/\1/p' "$said")
fi
if [[ ! $proposed ]]; then
  rm -rf "$runs".{proposed,random} "$runs".{proposed,random}.key "$folder/answers/$id".{proposed,random}
  exit 0
fi

others=()
for programme in paper reversed random_steps minor_loops ramp_rates power_cycles axis_flips rate_table heater_pulses \
  field_and_vibration long_soak; do
  [[ $programme == "$proposed" ]] || others+=("$programme")
done
drawn=${others[$(($(cksum <<<"$id" | cut -d' ' -f1) % ${#others[@]}))]}

# more_of NAME PROGRAMME: the case ID.NAME has the recordings of ID and one more.
more_of() {
  local more=$runs.$1 words
  [[ -f $more.key && $(<"$more.key") == "$key $2" ]] && return
  rm -rf "$more"
  mkdir "$more"
  ln "$runs"/run*.csv "$runs/effects.txt" "$more"
  echo once >"$more/request.txt"
  # The gyro of the first run, with another seed of its noise.
  read -ra words < <(sed -nE "s/^run1 --profile [a-z_]+ --seed ([0-9]+)/--profile $2 --seed 9\1/p" \
    "$truth/simulate.txt")
  [[ $2 == axis_flips && " ${words[*]} " != *" --latitude "* ]] && words+=(--latitude 34.27)
  "$fogcomp" simulate -o "$more/run9.csv" "${words[@]}" >"$truth/said.txt"
  echo "$key $2" >"$more.key"
}
more_of proposed "$proposed"
more_of random "$drawn"
