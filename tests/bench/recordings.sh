#!/usr/bin/env bash
# recordings.sh: cost of a whole chamber programme at 200 Hz (16.5 h, 11.9 million rows): processor and wall-clock
# seconds, and peak memory, of writing, reading and using it. Prints figures; never fails. Needs a scratch folder of 1
# GB.
set -euo pipefail
cd "$(dirname "$0")/../.."
fogcomp=$PWD/build/host/fogcomp
[[ -x $fogcomp ]] || { echo "build first: cmake --preset host && cmake --build build/host" >&2; exit 2; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

# measure WHAT COMMAND...: runs it, prints a row. Memory is the kernel's own high-water mark of the process.
measure() {
  local what=$1
  shift
  "$@" >out 2>err &
  local pid=$! most_kib=0 now
  while kill -0 "$pid" 2>/dev/null; do
    now=$(awk '/^VmHWM/ { print $2 }' "/proc/$pid/status" 2>/dev/null || true)
    [[ -n $now ]] && most_kib=$now
    sleep 0.05
  done
  wait "$pid" || { cat err >&2; exit 1; }
  local cpu
  cpu=$({ TIMEFORMAT='%U %S %R'; time "$@" >out 2>err; } 2>&1)
  awk -v what="$what" -v kib="$most_kib" \
    '{ printf "%-44s %8.2f %8.2f %8.0f\n", what, $1 + $2, $3, kib / 1024 }' <<<"$cpu"
}

printf '%-44s %8s %8s %8s\n' "11,910,000 rows" "CPU, s" "clock, s" "MiB"
measure "simulate to CSV" "$fogcomp" simulate -o run.csv --rate 200
measure "simulate to a sensor stream" "$fogcomp" simulate -o run.bin --rate 200 --format stream
measure "info of the CSV (read, Allan, all of it)" "$fogcomp" info run.csv
measure "info of the sensor stream" "$fogcomp" info run.bin
measure "fit of 3 effects and 6 neurons" "$fogcomp" fit run.csv -o gyro.model \
  --effects bias,bias_temperature,temperature_rate --network 6
measure "compare" "$fogcomp" compare gyro.model run.csv
measure "replay of the sensor stream" "$fogcomp" replay gyro.model run.bin -o out.bin
ls -l run.csv run.bin | awk '{ printf "%s: %.0f MB\n", $NF, $5 / 1e6 }'
