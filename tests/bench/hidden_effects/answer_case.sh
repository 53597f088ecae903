#!/usr/bin/env bash
# answer_case.sh FOGCOMP DIR KEY ID: writes the tool's answers for the recordings in DIR/runs/ID to DIR/answers/ID. Uses
# the declared effects, not the truth. Skipped if tool and recordings are those of DIR/answers/ID/key.
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

# knows COMMAND WORD: whether the command's help has that word. Features that the tool lacks are not tested.
knows() { [[ $("$fogcomp" "$1" --help 2>&1) == *"$2"* ]]; }

if ask fit "$fogcomp" fit "${recordings[@]}" -o "$answers/declared.model" --effects "$(<"$runs/effects.txt")" \
  --json; then
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
  # Runs the proposal as printed.
  next=$(sed -nE 's/.*"next":"fogcomp (add [^"]*)".*/\1/p' "$answers/diagnosis.json")
  if [[ $next ]]; then
    status=0
    eval "\"\$fogcomp\" ${next/NEW.model/\"\$answers/typed.model\"}" >"$answers/typed.out" 2>&1 || status=$?
    echo "$status" >"$answers/typed.txt"
  fi
  if grep -qw loop "$runs/request.txt" && knows diagnose --max-effects; then
    ask loop "$fogcomp" diagnose "$answers/declared.model" "${recordings[@]}" --max-effects 4 \
      -o "$answers/loop.model" --json || true
    if [[ -f $runs/unseen.csv ]]; then
      ask before "$fogcomp" compare "$answers/declared.model" "$runs/unseen.csv" --json || true
      [[ ! -f $answers/loop.model ]] || ask after "$fogcomp" compare "$answers/loop.model" "$runs/unseen.csv" \
        --json || true
    fi
  fi
fi
echo "$key" >"$answers/key"
