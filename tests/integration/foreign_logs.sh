#!/usr/bin/env bash
# foreign_logs.sh FOGCOMP PACKAGES [ULOG]: `fogcomp convert` makes of one recording, written as log of several programs,
# the table that it is, to the last digit of every stamp and value; it refuses what it cannot read or choose in one
# line, with nothing written. PACKAGES: the importers beside FOGCOMP, whose packages are installed if need be. ULOG: a
# real log, if there is one.
set -euo pipefail
source "$(dirname "$0")/common.sh"
tool=$(realpath "${1:?usage: foreign_logs.sh FOGCOMP PACKAGES [ULOG]}") packages=$(realpath "$2") ulog=${3:-}
[[ -z $ulog || ! -f $ulog ]] || ulog=$(realpath "$ulog")
fogcomp=$tool here=$(realpath "$(dirname "$0")")
command -v node >/dev/null || { echo "skipped: no node here"; exit 77; }
[[ -d $packages/node_modules ]] || npm ci --prefix "$packages" --no-audit --no-fund >/dev/null 2>&1 ||
  { echo "skipped: npm is missing or offline"; exit 77; }
enter_scratch
node "$here/foreign_logs/write_logs.mjs" "$packages"

# converts LOG EXPECTED [OPTION...]: as it was written, and the command that is proposed next is accepted.
converts() {
  local log=$1 expected=$2
  shift 2
  "$fogcomp" convert "$log" -o run.csv "$@" >said.txt 2>remarks.txt || fail "$log: $(cat remarks.txt)"
  cmp run.csv "$expected" || fail "$log: $(diff run.csv "$expected" | head -n 4)"
  says said.txt '^run\.csv: 400 samples$' "$log"
  [[ $(wc -l <remarks.txt) == 1 ]] || fail "$log: $(cat remarks.txt)"
  local next
  next=$(sed -n 's/^  next: fogcomp //p' said.txt)
  [[ -n $next ]] || fail "$log: no next command: $(cat said.txt)"
  eval "\"$fogcomp\" $next" >info.txt 2>remarks.txt || fail "$log, $next: $(cat remarks.txt)"
}
converts run.mcap ros.csv
says info.txt '390 samples at 50 Hz, 7\.8 s'
converts ros1.mcap ros.csv
converts two.mcap ros.csv --topic /imu/raw
converts run.mcap ros.csv --topic /imu/data,/temp
converts run.bag ros.csv
converts packed.bag ros.csv
converts run.db3 ros.csv
for log in logged.{mcap,bag,db3}; do converts "$log" logged.csv; done
converts run.ulg ulog.csv
converts run.parquet parquet.csv
converts run.h5 hdf5.csv --topic /run
"$fogcomp" convert run.h5 -o run.csv --topic / >said.txt 2>remarks.txt
cmp run.csv matrix.csv
says remarks.txt "^run\.csv:1: rate could be column 1 'gyro_1 \[rad/s\]' or " # as the next command would say
cut -d, -f1,3- ros.csv >no_temperature.csv
converts cold.mcap no_temperature.csv
says said.txt '--temperature 25$'

# refuses REGEX ARGUMENT...: in one line, exit code 2, and an output that exists stays.
refuses() {
  local expected=$1 status=0
  shift
  echo kept >kept
  "$fogcomp" convert "$@" -o kept >said.txt 2>remarks.txt || status=$?
  ((status == 2)) || fail "$*: exit code $status"
  [[ ! -s said.txt && $(wc -l <remarks.txt) == 1 && $(<kept) == kept ]] || fail "$*: $(cat said.txt remarks.txt)"
  says remarks.txt "$expected" "$*"
}
refuses '^two\.mcap: the rate could be of /imu/data \(sensor_msgs/msg/Imu, 400\), /imu/raw .*: --topic /imu/data$' two.mcap
refuses '^run\.h5: the rate could be of /run \(gyro_z \[rad/s\] temp \[degC\] time \[ns\], 400\), / ' run.h5
refuses "^run\.mcap: has no topic '/imu'; those that have a rate: /imu/data " run.mcap --topic /imu
refuses "^run\.mcap: '/temp' .* has no rate; those that have: /imu/data " run.mcap --topic /temp
refuses '^--topic: means nothing for ros\.csv; ' ros.csv --topic /imu
refuses '^--rate-column: means nothing for run\.mcap; ' run.mcap --rate-column rate_x
for log in run.mcap run.bag run.db3 run.h5 run.parquet; do
  head -c 9000 "$log" >"cut_$log"
  refuses "^cut_$log: .*(is it complete\?|mcap recover)" "cut_$log"
done
{ head -c 150000 run.db3; head -c 13840 /dev/zero; } >zeros.db3
refuses '^zeros\.db3: cannot be read' zeros.db3

# Without node, without their packages the scripts say how these are installed; info says what convert is for.
printf '#!/bin/sh\nPATH=/nowhere exec "%s" "$@"\n' "$tool" >without_node
chmod +x without_node
fogcomp=$PWD/without_node
refuses '^run\.mcap: node, .* cannot be run .*; install it: apt-get install nodejs npm$' run.mcap
mkdir -p prefix/bin prefix/share/fogcomp/importers
cp "$tool" prefix/bin/fogcomp
cp "$packages"/*.mjs "$packages"/*.json prefix/share/fogcomp/importers
fogcomp=$PWD/prefix/bin/fogcomp
refuses "^run\.mcap: .* install it: npm ci --prefix '$PWD/prefix/share/fogcomp/importers'$" run.mcap
rm -r prefix/share
refuses '^fogcomp convert: its scripts .* are missing' run.mcap
! "$fogcomp" info run.mcap 2>remarks.txt || fail "info reads an MCAP file"
says remarks.txt '^run\.mcap: is an MCAP file; make a CSV of it: fogcomp convert run\.mcap -o run\.csv$'

fogcomp=$tool
[[ -n $ulog && -f $ulog ]] || { echo "(no real log at '$ulog')"; exit; }
"$fogcomp" convert "$ulog" -o real.csv --topic sensor_combined,sensor_gyro:0 >said.txt
says said.txt '^real\.csv: 1298 samples$'
[[ $(sed -n 2p real.csv) == 20.326716,,0.002968383487313986,0.003646239871159196,0.0009424961172044277 ]] ||
  fail "$(head -n 2 real.csv)"
