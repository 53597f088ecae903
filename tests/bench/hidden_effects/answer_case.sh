#!/usr/bin/env bash
# answer_case.sh FOGCOMP DIR KEY ID: what the tool says to the recordings in DIR/runs/ID, into DIR/answers/ID. Knows
# the declared effects and nothing of the truth. Done already where tool and recordings are those of DIR/answers/ID/key.
set -euo pipefail
fogcomp=$1 runs=$2/runs/$4 answers=$2/answers/$4
key="$3 $(cat "$runs"/* | cksum)"
[[ -f $answers/key && $(<"$answers/key") == "$key" ]] && exit 0
rm -rf "$answers"
mkdir -p "$answers"
recordings=("$runs"/run*.csv)

# ask NAME COMMAND...: stdout into NAME.json; exit codes above 1, and signals, are failures of the tool.
ask() {
  local name=$1 status=0
  shift
  "$@" >"$answers/$name.json" 2>"$answers/$name.err" || status=$?
  ((status <= 1)) || echo "$name exit $status: $(tail -n 1 "$answers/$name.err")" >>"$answers/failed.txt"
  ((status <= 1))
}

# knows COMMAND WORD: the command's help has that word. What a tool cannot do yet is not asked for.
knows() { [[ $("$fogcomp" "$1" --help 2>&1) == *"$2"* ]]; }

if ask fit "$fogcomp" fit "${recordings[@]}" -o "$answers/declared.model" --effects "$(<"$runs/effects.txt")" --json; then
  TIMEFORMAT='%U'
  { time ask diagnosis "$fogcomp" diagnose "$answers/declared.model" "${recordings[@]}" --json || true; } \
    2>"$answers/seconds.txt"
  effect=$(sed -nE '/"verdict":"missing_effect"/ s/^[^[]*"effect":"([a-z_]+)".*/\1/p' "$answers/diagnosis.json")
  # A bias step is an event of one recording: it is masked, not added.
  if [[ $effect && $effect != bias_step && -f $runs/unseen.csv ]] && knows add RUN; then
    ask add "$fogcomp" add "$answers/declared.model" "$effect" "${recordings[@]}" -o "$answers/added.model" --json &&
      [[ -f $answers/added.model ]] && # exit code 1: refused
      ask unseen "$fogcomp" compare "$answers/added.model" "$runs/unseen.csv" --json || true
  fi
  # What it proposes, as it is printed.
  next=$(sed -nE 's/.*"next":"fogcomp (add [^"]*)".*/\1/p' "$answers/diagnosis.json")
  if [[ $next ]]; then
    status=0
    eval "\"\$fogcomp\" ${next/NEW.model/\"\$answers/typed.model\"}" >"$answers/typed.out" 2>&1 || status=$?
    echo "$status" >"$answers/typed.txt"
  fi
  if grep -qw loop "$runs/request.txt" && knows diagnose --max-effects; then
    ask loop "$fogcomp" diagnose "$answers/declared.model" "${recordings[@]}" --max-effects 4 -o "$answers/loop.model" --json || true
    if [[ -f $runs/unseen.csv ]]; then
      ask before "$fogcomp" compare "$answers/declared.model" "$runs/unseen.csv" --json || true
      [[ ! -f $answers/loop.model ]] || ask after "$fogcomp" compare "$answers/loop.model" "$runs/unseen.csv" --json || true
    fi
  fi
fi
echo "$key" >"$answers/key"
