#!/usr/bin/env bash
# production_line.sh MACHINE FLASH ELF FOGCOMP IN.bin DIR: from recordings to a gyro that ships, without a compiler: the
# five commands of firmware/README.md as they stand there, on an emulated board with the generic image ELF, whose
# service strap is closed. OpenOCD's part QEMU takes, which starts with the image, and the demodulator's this test. The
# gyro is calibrated again and loaded again: the board keeps the table before. A strap that is open, and a table of
# another gyro, are refused. The emulated STM32F405 has no flash that can be written: it says so, and its table comes as
# from a programmer.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
machine=$1 slot=$(($2 + 48 * 1024)) elf=$(realpath "$3") fogcomp=$(realpath "$4") input=$(realpath "$5") folder=$6
here=$(realpath "$(dirname "$0")")
rm -rf "$folder"
mkdir -p "$folder"
source "$here/board_session.sh"
cd "$folder"
can_be_loaded=false
[[ $machine != mps2-an386 ]] || can_be_loaded=true

# start OPTION...: the board, its output port a socket, and what it sends in $scratch/sent.
start() {
  rm -f "$scratch"/{output,sent,sensor.in,sensor.out}
  mkfifo "$scratch/sensor.in" "$scratch/sensor.out"
  : >"$scratch/console"
  timeout --kill-after=1 120 qemu-system-arm -M "$machine" -display none -monitor none \
    -chardev "socket,id=output,path=$scratch/output,server=on,wait=off,logfile=$scratch/sent" -serial chardev:output \
    -serial "pipe:$scratch/sensor" -serial "file:$scratch/console" "$@" -kernel "$elf" </dev/null >"$scratch/log" 2>&1 &
  qemu=$!
  wait_for booted
}
stop() {
  kill "$qemu"
  wait "$qemu" || true
}
strap=()
! $can_be_loaded || strap=(-device "loader,addr=0x20020000,data=1,data-len=4")

for gyro in FOG-0042 FOG-0043; do
  mkdir -p "gyros/$gyro"
  "$fogcomp" simulate -o "gyros/$gyro/run.csv" --seed "${gyro#FOG-00}" >said.txt
done
echo "fit_rms_dph <= 1" >limits.txt
cp "$input" in.bin

# The commands as a station types them.
fogcomp() { "$fogcomp" "$@"; }
openocd() {
  [[ $* == *fogcomp.elf* ]]
  start "${strap[@]}"
}
mapfile -t commands < <(awk '/the line from the chamber/ { found = 1 }
  found && /^    / { print substr($0, 5); any = 1 }
  any && !/^    / { exit }' \
  "$here/../../firmware/README.md")
((${#commands[@]} == 5)) || fail "${#commands[@]} commands in the README"
# run NUMBER: one of them, its output in said.txt.
run() {
  local status=0
  echo "\$ ${commands[$1]}"
  eval "${commands[$1]//\/dev\/ttyUSB1/$scratch/output}" >said.txt || status=$?
  cat said.txt
  return "$status"
}
# asks NUMBER: health, of a board that is well but that nothing comes in.
asks() {
  local status=0
  run "$1" || status=$?
  ((status == 1)) && grep -qx 'board         NOT HEALTHY: no samples come' said.txt
}
# sheet GYRO: its line's CRC-32 of the model.
sheet() { sed -nE "s/^\"$1\",$1,any,([0-9a-f]{8}),.*/\1/p" results/tables/sheet.csv; }
# plays_as_expected: the board, as it is now, sends what the last command expects for in.bin.
plays_as_expected() {
  local before expected
  expected=$(stat -c %s expected.bin)
  before=$(stat -c %s "$scratch/sent")
  cat in.bin >"$scratch/sensor.in" &
  has_come() { (($(stat -c %s "$scratch/sent") >= before + expected)); }
  wait_for has_come
  cmp expected.bin <(tail -c +$((before + 1)) "$scratch/sent")
}
# refuses WHAT OPTION...: a load that the board or the tool refuses, and why.
refuses() {
  local what=$1 status=0
  shift
  "$fogcomp" load "$scratch/output" "$@" 2>errors.txt || status=$?
  cat errors.txt
  ((status == 2)) && grep -q "$what" errors.txt
}

run 0
run 1
if ! $can_be_loaded; then
  refuses 'flash does not hold' results/tables/FOG-0042.bin --serial FOG-0042
  stop
  start -device "loader,file=results/tables/FOG-0042.bin,addr=$slot,force-raw=on"
  asks 3
  grep -q "CRC-32 $(sheet FOG-0042), of gyro FOG-0042" said.txt
  run 4
  plays_as_expected
  exit 0
fi

run 2
asks 3
grep -q "CRC-32 $(sheet FOG-0042), of gyro FOG-0042" said.txt
grep -qE '^slot 0 +good, sequence 1, .*: in use$' said.txt
grep -qE '^slot 1 +missing$' said.txt
tr -d '\r' <"$scratch/console" | grep -x "model 0x$(sheet FOG-0042) of FOG-0042: good"
run 4
plays_as_expected
mv expected.bin first.bin

refuses 'is of gyro FOG-0043, and the board.s table of gyro FOG-0042' results/tables/FOG-0043.bin
"$fogcomp" simulate -o gyros/FOG-0042/run.csv --seed 7 >said.txt
old=$(sheet FOG-0042)
run 1
[[ $(sheet FOG-0042) != "$old" ]]
[[ $(cut -d, -f 1,2 results/history/tables.csv |
  tr '\n' ' ') == 'gyro,sequence "FOG-0042",1 "FOG-0043",1 "FOG-0042",2 ' ]]
run 2
asks 3
grep -qE "^slot 0 +good, sequence 1, model CRC-32 $old, .*, of gyro FOG-0042$" said.txt
grep -qE "^slot 1 +good, sequence 2, model CRC-32 $(sheet FOG-0042), .*, of gyro FOG-0042: in use$" said.txt
run 4
plays_as_expected
! cmp -s first.bin expected.bin
"$fogcomp" load "$scratch/output" results/tables/FOG-0043.bin --another-gyro --json | tee said.txt
grep -qE '"slot": ?0,"sequence": ?3,.*"gyro_serial": ?"FOG-0043"' <(tr -d ' \n' <said.txt)
stop

strap=()
start
refuses 'strap is open' results/tables/FOG-0042.bin --serial FOG-0042
"$fogcomp" health "$scratch/output" --json >empty.json || true
grep -qE '"model_finding": ?"missing"' empty.json
