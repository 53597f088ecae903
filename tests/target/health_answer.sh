#!/usr/bin/env bash
# health_answer.sh MACHINE ELF FOGCOMP IN.bin DIR: the product image, asked by `fogcomp health` on its output port
# while it answers the sensor stream IN.bin, tells how it is, between its frames; and an image with a flipped bit
# says that it is damaged.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
machine=$1 elf=$2 fogcomp=$3 input=$4 folder=$5
mkdir -p "$folder"
source "$(dirname "$0")/board_session.sh"

# start ELF: boots it in $scratch, its output port a socket there.
start() {
  rm -f "$scratch"/{output,sensor.in,sensor.out,console}
  mkfifo "$scratch/sensor.in" "$scratch/sensor.out"
  : >"$scratch/console"
  timeout --kill-after=1 120 qemu-system-arm -M "$machine" -display none -monitor none \
    -serial "unix:$scratch/output,server=on,wait=off" -serial "pipe:$scratch/sensor" \
    -serial "file:$scratch/console" -kernel "$1" </dev/null >"$scratch/log" 2>&1 &
  qemu=$!
  wait_for booted
}

start "$elf"
cat "$input" >"$scratch/sensor.in" &
# A board that has just started has no valid rate yet, or no sample: nothing else is wrong.
status=0
"$fogcomp" health "$scratch/output" --timeout 30 | tee "$folder/good.txt" || status=$?
((status == 1))
"$fogcomp" health "$scratch/output" --timeout 30 --json | tee "$folder/good.json" || true
grep -q '^image  *intact' "$folder/good.txt"
grep -qE '^board  *NOT HEALTHY: (no samples come|rate not valid now \([a-z_, ]*\))$' "$folder/good.txt"
grep -qx 'rate  *2325 ms late (465 samples), -3 dB at 2.85 Hz for what is below its thresholds' "$folder/good.txt"
grep -q '"healthy":false,"complaints":\["' <(tr -d ' \n' <"$folder/good.json")
grep -q '"rate_delay_s":2.325,"rate_minus_3db_hz":2.84' <(tr -d ' \n' <"$folder/good.json")
# The checked-in model has no serial: the console names no gyro.
tr -d '\r' <"$scratch/console" | grep -qxE 'model 0x[0-9a-f]{8}: good' ||
  fail "console: $(cat "$scratch/console")"
kill "$qemu"
wait "$qemu" || true

# One bit of the boot message's text: harmless to run, and found all the same.
cp "$elf" "$scratch/damaged.elf"
at=$(LC_ALL=C grep -abo 'no rate is valid' "$elf" | head -n 1 | cut -d: -f1)
printf 'N' | dd of="$scratch/damaged.elf" bs=1 seek="$at" conv=notrunc status=none
start "$scratch/damaged.elf"
cat "$input" >"$scratch/sensor.in" &
status=0
"$fogcomp" health "$scratch/output" --timeout 30 | tee "$folder/damaged.txt" || status=$?
((status == 1))
grep -q '^image  *DAMAGED' "$folder/damaged.txt"
