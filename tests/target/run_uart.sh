#!/usr/bin/env bash
# run_uart.sh MACHINE ELF IN.bin OUT.bin EXPECTED_BYTES [QEMU OPTION...]: boots the product image on QEMU's MACHINE,
# plays the sensor stream IN.bin into its sensor port and collects its output stream in OUT.bin, its
# console in OUT.bin.console. Ends when EXPECTED_BYTES have come out, and with exit code 1 if they have
# not after FOG_QEMU_TIMEOUT_S (default 60). FOG_OUTPUT_PORT: QEMU's number of the output port, if it is not 0.
set -euo pipefail
(($# >= 5)) || { echo "usage: run_uart.sh MACHINE ELF IN.bin OUT.bin EXPECTED_BYTES [OPTION...]" >&2; exit 2; }
machine=$1
elf=$2
input=$3
output=$(realpath "$4")
expected_bytes=$5
options=("${@:6}")
timeout_s=${FOG_QEMU_TIMEOUT_S:-60}
deadline=$((SECONDS + timeout_s))

source "$(dirname "$0")/board_session.sh"

give_up() {
  echo "$machine uart: $1" >&2
  cat "$scratch/qemu.log" "$output.console" >&2
  exit 1
}

# poll_for WHAT COMMAND...: polls until COMMAND succeeds.
poll_for() {
  local what=$1
  shift
  until "$@"; do
    ((SECONDS < deadline)) || give_up "no $what within $timeout_s s"
    kill -0 "$qemu" 2>/dev/null || give_up "QEMU ended before $what"
    sleep 0.02
  done
}
is_ready() { grep -q ready "$output.console"; }
is_complete() { (($(stat -c %s "$output") >= expected_bytes)); }

# Serial ports 0 to 5 are USART 1 to 6 of the STM32, 0 to 2 UART 0 to 2 of the MPS2: output, sensor, console, or on
# another board sensor, console and, further back, output. `timeout` ends QEMU even if this script is killed outright.
mkfifo "$scratch/sensor.in" "$scratch/sensor.out"
: >"$output"
: >"$output.console"
ports=(-serial "file:$output" -serial "pipe:$scratch/sensor" -serial "file:$output.console")
if ((${FOG_OUTPUT_PORT:-0} > 0)); then
  ports[1]=null
  for ((port = 3; port < FOG_OUTPUT_PORT; ++port)); do ports+=(-serial null); done
  ports+=(-serial "file:$output")
fi
emulator=qemu-system-arm
if [[ $machine == virt ]]; then # one port, whose two directions are sensor and output; the console is semihosted
  emulator="qemu-system-riscv32 -bios none"
  ports=(-serial "pipe:$scratch/sensor" -chardev "file,id=console,path=$output.console"
         -semihosting-config enable=on,target=native,chardev=console)
  cat "$scratch/sensor.out" >"$output" &
fi
# shellcheck disable=SC2086
timeout --kill-after=1 "$((timeout_s + 5))" \
  $emulator -M "$machine" -display none -monitor none \
  "${ports[@]}" "${options[@]}" \
  -kernel "$elf" </dev/null >"$scratch/qemu.log" 2>&1 &
qemu=$!

# Bytes sent before the USART is enabled would be lost.
poll_for "boot message" is_ready
cat "$output.console"
start_us=${EPOCHREALTIME/./}
cat "$input" >"$scratch/sensor.in" &
poll_for "$expected_bytes bytes of output" is_complete
elapsed_us=$((${EPOCHREALTIME/./} - start_us))

# The answer to one sample more comes behind whatever else there was to send: a byte too many stands before it.
is_answered() { (($(stat -c %s "$output") >= expected_bytes + 2)); }
tail -c 16 "$input" >"$scratch/sensor.in"
poll_for "answer to one sample more" is_answered
kill "$qemu"
wait "$qemu" || true
next() { tail -c +$((expected_bytes + 1)) "$output" | head -c "$1"; }
cmp -s <(head -c 2 "$output") <(next 2) ||
  give_up "after $expected_bytes bytes comes no frame, but $(next 8 | od -An -t x1)"
truncate -s "$expected_bytes" "$output"

frames=$(($(stat -c %s "$input") / 16))
echo "$machine uart: $frames frames in $((elapsed_us / 1000)) ms," \
  "$((frames * 1000000 / elapsed_us)) frames/s"
