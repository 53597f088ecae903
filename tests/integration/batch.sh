#!/usr/bin/env bash
# batch.sh FOGCOMP SOURCE: a lot of gyros is calibrated although one has a bad recording, one has none, one crashes and
# one hangs; finished gyros are not repeated, changed ones are; gyros calibrated one by one give the same table; Ctrl-C
# leaves no unfinished file and no process.
set -euo pipefail
source "$(dirname "$0")/common.sh"
fogcomp=$(realpath "${1:?usage: batch.sh FOGCOMP SOURCE}")
submit=$(realpath "$2/host_tools/batch/slurm/submit.sh")
enter_scratch
options=(--effects bias,bias_temperature,temperature_rate --jobs 2)

# batch EXIT_CODE ARGUMENTS...
batch() {
  local expected=$1 status=0
  shift
  "$fogcomp" batch "${options[@]}" "$@" >said.txt 2>errors.txt || status=$?
  ((status == expected)) || fail "exit code $status, not $expected: $* $(cat said.txt errors.txt)"
}
outcome() { awk -F, -v gyro="$1" '$1 == gyro { print $2 }' "${2:-out}/gyros.csv"; }

for gyro in A1 A2 A3; do
  mkdir -p "gyros/$gyro"
  "$fogcomp" simulate -o "gyros/$gyro/run.csv" --seed "${gyro#A}" >said.txt
done
"$fogcomp" simulate -o gyros/A1/holdout.csv --seed 9 --profile reversed >said.txt
cp gyros/A1/holdout.csv gyros/A2/holdout_random.csv
mkdir gyros/B1 gyros/B2
{ head -n 100 gyros/A1/run.csv; echo "not,a,row"; } >gyros/B1/run.csv
echo "no recording" >gyros/B2/notes.txt

# Sound gyros are calibrated, the others are listed with the reason.
batch 1 gyros -o out
says said.txt '^5 gyros: 3 pass, 0 fail, 2 without a result'
says said.txt '^5 calibrated now, 0 before'
says said.txt '^  B1 +error +gyros/B1/run.csv:101: '
says said.txt '^  B2 +error +gyros/B2: has no recording'
[[ $(outcome A1)$(outcome A2)$(outcome A3)$(outcome B1) == passpasspasserror ]] || fail "$(cat out/gyros.csv)"
grep -q '<a href="./A2/">A2</a>' out/index.html || fail "index.html does not lead to A2"
[[ -f out/A1/fog_model.h && ! -e out/B1/fog_model.h ]] || fail "headers"

# The gyro's own result is that of fit, compare and export one by one.
"$fogcomp" fit gyros/A1/run.csv -o A1.model --serial A1 --effects bias,bias_temperature,temperature_rate >said.txt
"$fogcomp" compare A1.model gyros/A1/holdout.csv --json >compare.json
"$fogcomp" export A1.model -o A1.h >said.txt
cmp A1.model out/A1/A1.model
cmp A1.h out/A1/fog_model.h
holds compare.json ".runs[0].residual_rms_dph == $(awk '$2 == "holdout_rms_dph" { print $3 }' out/A1/result.txt)"

# Finished gyros are not repeated; limits are judged without a new fit; changed recordings and options are repeated.
batch 1 gyros -o out
says said.txt '^2 calibrated now, 3 before'
rm -r gyros/B1 gyros/B2
printf '# limits\nholdout_rms_dph <= 0.001\ntemperature_rate.K >= 0.01 # deg/h per (degC/min)\n' >limits.txt
batch 1 gyros -o out --limits limits.txt
says said.txt '^3 gyros: 0 pass, 3 fail'
says said.txt '^0 calibrated now, 3 before'
says said.txt '^  A1 +fail +holdout_rms_dph 0\.[0-9]+, must be <= 0\.001'
says said.txt '^  A3 +fail +holdout_rms_dph is missing'
sed -i '50s/$/1/' gyros/A2/holdout_random.csv
batch 0 gyros -o out
says said.txt '^1 calibrated now, 2 before'
batch 0 gyros -o out --average 20
says said.txt '^3 calibrated now, 0 before'

# A table for each gyro that passes, from its own header, and a sheet; tables of earlier passes are removed.
batch 1 gyros -o out --average 20 --tables --limits limits.txt
[[ $(ls out/tables) == sheet.csv && $(wc -l <out/tables/sheet.csv) == 1 ]] || fail "tables: $(ls out/tables)"
batch 0 gyros -o out --average 20 --tables
[[ $(ls out/tables | tr '\n' ' ') == "A1.bin A1.hex A2.bin A2.hex A3.bin A3.hex sheet.csv " ]] ||
  fail "tables: $(ls out/tables)"
crc=$(sed -nE 's/.*CRC-32 ([0-9a-f]{8}),.*/\1/p' out/A2/fog_model.h)
grep -qE "^\"A2\",A2,any,$crc,[0-9a-f]{8},\"A2.bin\",\"A2.hex\",\"\"$" out/tables/sheet.csv ||
  fail "$(cat out/tables/sheet.csv)"
"$fogcomp" export out/A2/A2.model --format table -o A2.bin >said.txt
cmp A2.bin out/tables/A2.bin
"$fogcomp" stream out/A2/fog_model.h gyros/A2/run.csv -o A2.in >said.txt
"$fogcomp" replay out/A2/fog_model.h A2.in -o A2.expected >said.txt
"$fogcomp" replay out/tables/A2.bin A2.in -o A2.out >said.txt
cmp A2.expected A2.out
# Each is kept. That a gyro calibrated again gets the next number is a unit test (batch/tables_test).
header=gyro,sequence,table_crc32,model_crc32,serial,processor,bin,limits
[[ $(head -n 1 out/history/tables.csv) == "$header" && $(wc -l <out/history/tables.csv) == 4 ]] ||
  fail "$(cat out/history/tables.csv)"
grep -qE "^\"A2\",1,[0-9a-f]{8},$crc,A2,any,\"A2-1.bin\",\"\"$" out/history/tables.csv ||
  fail "$(cat out/history/tables.csv)"
cmp A2.bin out/history/A2-1.bin
printf 'noise_dprh <= 0\n' >strict.txt
batch 1 gyros -o out --average 20 --tables --limits strict.txt
[[ $(ls out/tables) == sheet.csv ]] || fail "a table of a gyro that fails: $(ls out/tables)"
batch 2 gyros -o seven --levels 7 --tables
grep -q 'denoisers of up to 6 levels, not 7' errors.txt || fail "$(cat errors.txt)"

# A gyro counts as finished as long as its files are unchanged.
batch 0 gyros -o out --average 20
says said.txt '^0 calibrated now, 3 before'
cp out/A1/fog_model.h sound.h
rm out/A1/A1.model
batch 0 gyros -o out --average 20
says said.txt '^1 calibrated now, 2 before'
sed -i 's/[0-9]/7/' out/A1/fog_model.h
batch 0 gyros -o out --average 20
says said.txt '^1 calibrated now, 2 before'
cmp sound.h out/A1/fog_model.h

# A serial number must not become a formula in a spreadsheet or a command of a terminal.
mkdir -p hostile/=cmd
cp gyros/A3/run.csv hostile/=cmd
batch 0 hostile -o hostile_out
grep -q "^'=cmd,pass," hostile_out/gyros.csv || fail "a formula: $(cat hostile_out/gyros.csv)"
mkdir hostile/$'\033[31m'
batch 2 hostile -o hostile_out
grep -q '^hostile/?\[31m: has a control character in its name; rename it$' errors.txt || fail "$(cat -v errors.txt)"
rm -r hostile hostile_out

# A gyro whose folder cannot be made does not stop the others either.
mkdir blocked
echo "in the way" >blocked/A2
batch 1 gyros -o blocked
says said.txt '^3 gyros: 2 pass, 0 fail, 1 without a result'
says said.txt '^  A2 +error +its process exited with code 2'
grep -q '^blocked/A2' errors.txt || fail "$(cat errors.txt)"

# One by one, as any scheduler may, then the table: the same bytes.
batch 0 gyros -o whole
for gyro in A1 A2/ A3; do
  "$fogcomp" calibrate "gyros/$gyro" -o parts "${options[@]:0:2}" >>one_by_one.txt
done
[[ $(cat one_by_one.txt) == "A1: pass"$'\n'"A2: pass"$'\n'"A3: pass" ]] || fail "$(cat one_by_one.txt)"
[[ ! -e parts/gyros.csv ]] || fail "one gyro wrote the table"
"$fogcomp" calibrate gyros/A1 -o parts "${options[@]:0:2}" >said.txt
says said.txt '^A1: pass \(calibrated before\)$'
status=0
"$fogcomp" calibrate gyros/A1 -o parts "${options[@]:0:2}" --limits limits.txt >said.txt || status=$?
says said.txt '^A1: fail, holdout_rms_dph 0\.[0-9]+, must be <= 0\.001 \(calibrated before\)$'
[[ $status == 1 && -s parts/A1/diagnosis.txt ]] || fail "exit code $status, or no diagnosis"
batch 0 gyros -o parts
says said.txt '^0 calibrated now, 3 before'
cmp whole/gyros.csv parts/gyros.csv

# The same as a job array, with an sbatch that does at once what it is given.
mkdir bin
cat >bin/sbatch <<'END'
#!/usr/bin/env bash
set -euo pipefail
cat >job.sh
tasks=0
for word in "$@"; do
  [[ $word == --array=1-* ]] && tasks=${word#--array=1-}
done
[[ $1 != --cpus-per-task=* ]] || export SLURM_CPUS_PER_TASK=${1#*=}
((tasks > 0)) || exec bash job.sh >merge.txt
for ((task = 1; task <= tasks; ++task)); do
  SLURM_ARRAY_TASK_ID=$task SLURM_ARRAY_TASK_MAX=$tasks bash job.sh >&2
done
echo 17
END
chmod +x bin/sbatch
PATH=$PWD/bin:$PATH FOGCOMP=$fogcomp SBATCH_OPTIONS="--cpus-per-task=2 --partition=lab" \
  "$submit" 2 gyros array "${options[@]:0:2}" --jobs 2 --tables >said.txt 2>tasks.txt || fail "$(cat tasks.txt)"
[[ $(sort tasks.txt) == "A1: pass"$'\n'"A2: pass"$'\n'"A3: pass" ]] || fail "$(cat tasks.txt)"
says merge.txt '^0 calibrated now, 3 before'
cmp whole/gyros.csv array/gyros.csv

# One hangs (its recording is a pipe without a writer) and is killed; one crashes: the rest continues.
mkdir gyros/C1
mkfifo gyros/C1/run.csv
cp -r whole hang # so that on a slow machine the limit ends nobody else
batch 1 gyros -o hang --time-limit 1
says said.txt '^  C1 +error +took longer than 1 s'
says said.txt '^4 gyros: 3 pass'
says said.txt '^1 calibrated now, 3 before'
mv gyros/A1 gyros/Z1 # after C1

# only_C1_runs FOLDER: waits until it is the last one; $child is then its process.
only_C1_runs() {
  until [[ -e $1/C1/log.txt && -e $1/Z1/result.txt ]]; do sleep 0.05; done
  child=$(pgrep -f "^$fogcomp calibrate .*$1 .*gyros/C1\$")
}
"$fogcomp" batch "${options[@]}" gyros -o crash >said.txt 2>errors.txt &
batch=$!
only_C1_runs crash
kill -SEGV "$child"
! wait "$batch" || fail "exit code 0 with a crash"
says said.txt '^  C1 +error +its process died of signal 11'
says said.txt '^4 gyros: 3 pass'
[[ $(wc -l <crash/jobs.txt) == 5 ]] || fail "$(cat crash/jobs.txt)"

# Ctrl-C ends all of its group (env: a shell that is not interactive has it ignored in the background).
setsid env --default-signal=INT "$fogcomp" batch "${options[@]}" gyros -o stopped >said.txt 2>errors.txt &
batch=$!
only_C1_runs stopped
kill -INT -- "-$batch"
status=0
wait "$batch" || status=$?
((status == 130)) || fail "exit code $status after SIGINT"
timeout 20 tail --pid="$child" -f /dev/null || fail "a process is left"
grep -q '^interrupted; the same command continues there' errors.txt || fail "$(cat errors.txt)"
[[ -z $(find stopped -name '*.part-*') && ! -e stopped/gyros.csv ]] || fail "half files: $(find stopped)"
rm -r gyros/C1
batch 0 gyros -o stopped
says said.txt '^0 calibrated now, 3 before'

# What a refusal of the board proposes, calibrate takes.
ageing=(calibrate gyros/A2 -o ageing --effects bias,aging)
"$fogcomp" "${ageing[@]}" >said.txt && fail "an effect that goes on without power is exported"
says said.txt 'give --allow-error for a board that is never switched off'
"$fogcomp" "${ageing[@]}" --allow-error >said.txt || fail "--allow-error: $(cat said.txt)"
says said.txt '^A2: pass$'
mkdir -p nested/gyros/A2
"$fogcomp" calibrate nested/gyros -o ageing --effects bias >said.txt && fail "a folder of gyros is a gyro"
says said.txt 'fogcomp batch takes a folder of gyros'

# Nobody who lacks GNU parallel gets a table without gyros.
status=0
PATH=$PWD/bin "$fogcomp" batch "${options[@]}" gyros -o none >said.txt 2>errors.txt || status=$?
((status == 2)) || fail "exit code $status without parallel"
grep -q '^parallel: GNU parallel runs the gyros, and is not there; install it (apt-get install parallel)$' errors.txt ||
  fail "$(cat errors.txt)"
[[ ! -e none/gyros.csv ]] || fail "a table without gyros"
echo "a lot of gyros goes through, whatever one of them does"
