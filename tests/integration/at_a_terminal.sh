#!/usr/bin/env bash
# at_a_terminal.sh FOGCOMP: long work shows a progress bar, only on a terminal; Ctrl-C leaves no unfinished file and the
# old file unchanged; a training ends early with its best weights.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: at_a_terminal.sh FOGCOMP}")
command -v script >/dev/null || { echo "skipped: no script(1) here"; exit 77; }
enter_scratch
"$fogcomp" simulate -o run.csv >said.txt
echo "kept" >big.csv

# at_terminal COMMAND...: runs it in the background on a terminal whose screen is in screen.txt; its process is `pid`.
at_terminal() {
  rm -f screen.txt pid status
  # shellcheck disable=SC2016
  env --default-signal=INT script -qefc "bash -c 'echo \$\$ >pid; exec $(printf '%q ' "$@")'" screen.txt >said.txt \
    </dev/null || echo $? >status &
  until [[ -s pid ]]; do sleep 0.02; done
}
# wait_for REGEX: waits for it on the screen, for as long as the process lives: how long that takes, the machine decides.
wait_for() {
  until grep -qaE "$1" screen.txt 2>/dev/null; do
    kill -0 "$(cat pid)" 2>/dev/null || fail "it ended without $1: $(cat screen.txt)"
    sleep 0.05
  done
}

# More than 2 s of work. The bar, then Ctrl-C: nothing of the file, and the old one.
at_terminal "$fogcomp" simulate -o big.csv --rate 500
wait_for 'simulating \[#* *\] +[0-9]+ %, [0-9]+ s left'
kill -INT "$(cat pid)"
wait
[[ $(cat status) == 130 ]] || fail "exit code $(cat status)"
[[ $(cat big.csv) == kept && -z $(find . -name '*.part-*') ]] || fail "half a file: $(ls)"

# A training ends with its present result.
at_terminal "$fogcomp" fit run.csv -o gyro.model --effects bias --network 10 --trainer pso-bp --iterations 100000 \
  --force-network
wait_for 'training \[#* *\] +[0-9]+ %, [0-9]+ s left'
kill -INT "$(cat pid)"
wait
[[ ! -e status ]] || fail "exit code $(cat status): $(cat screen.txt)"
grep -qa 'interrupted: the best network of' screen.txt || fail "$(cat screen.txt)"
"$fogcomp" compare gyro.model run.csv >said.txt

# A search for shapes, and Ctrl-C in it: six runs in rows of 1 s, some thirty times what it takes until a bar shows.
for seed in 1 2 3 4 5 6; do
  "$fogcomp" simulate -o long$seed.csv --profile random_steps --rate 1 --seed $seed >said.txt
done
echo "kept" >long.model
at_terminal "$fogcomp" fit long[1-6].csv -o long.model --average 1 \
  --effects bias,polarization_ripple,thermal_hysteresis,glass_transition,shupe --network 4
wait_for 'fitting effects \[#* *\] +[0-9]+ %, [0-9]+ s left'
kill -INT "$(cat pid)"
wait
[[ $(cat status) == 130 && $(cat long.model) == kept ]] || fail "exit code $(cat status): $(cat screen.txt)"

# The same into a file, for longer than it takes until a bar would show: no bar, no escape sequence, and the result.
rm gyro.model
env --default-signal=INT "$fogcomp" fit run.csv -o gyro.model --effects bias --network 10 --trainer pso-bp \
  --iterations 100000 --force-network \
  >said.txt 2>errors.txt &
pid=$!
until age=$(ps -o etimes= -p "$pid") && ((age >= 5)); do
  kill -0 "$pid" 2>/dev/null || fail "it ended by itself: $(cat said.txt errors.txt)"
  sleep 0.1
done
kill -INT "$pid"
wait "$pid" || fail "exit code $?: $(cat errors.txt)"
grep -q 'interrupted: the best network of' said.txt errors.txt || fail "it did not train: $(cat said.txt errors.txt)"
"$fogcomp" compare gyro.model run.csv >compared.txt
! grep -q $'[\r\033]' said.txt errors.txt || fail "a bar in a file: $(cat errors.txt)"
echo "bars on terminals, whole files or none"
