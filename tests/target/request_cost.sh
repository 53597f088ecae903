#!/usr/bin/env bash
# request_cost.sh ELF FOGCOMP MAKE_MODEL DIR: what answering requests costs a pass of the main loop, and what the tests of
# the start cost, in instructions that QEMU counts in the generic image. All requests are answered meanwhile. A pass takes
# 12 bytes, so two health requests. The start has half the cycles of its watchdog (500 ms at 144 MHz).
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
elf=$(realpath "$1") fogcomp=$(realpath "$2") make_model=$(realpath "$3") folder=$4
mkdir -p "$folder"
cd "$folder"
"$make_model" all.model 4 all 'burst=T*T*dTdt' 'late=lag(T,300)-play(T,?r[2,9])'
"$fogcomp" export all.model --format table -o all.bin --extension --allow-error --kvh-commands --output both >said.txt
: >in.bin

# expect_cost REQUEST TIMES ANSWER_BYTES MOST: sent so often in a row, as printf understands it.
expect_cost() {
  rm -f sensor console port.in port.out
  mkfifo port.in port.out
  for ((i = 0; i < $2; ++i)); do printf '%b' "$1"; done >requests.bin
  cat port.out >answers.bin &
  timeout --kill-after=1 100 qemu-system-arm -M netduinoplus2 -display none -monitor none -icount shift=0,sleep=off \
    -semihosting-config enable=on,target=native -device loader,addr=0x0800C000,file=all.bin,force-raw=on \
    -serial pipe:port -serial null -serial file:console -kernel "$elf" </dev/null >said.txt 2>&1 &
  local qemu=$!
  until grep -q 'requests, please' console 2>/dev/null; do
    kill -0 "$qemu" 2>/dev/null || fail "the image asks for no requests: $(cat said.txt)"
    sleep 0.05
  done
  cat requests.bin >port.in
  wait
  [[ $(tr -d '\r' <console) =~ start:\ count\ 1\ mean\ [0-9]+\ max\ ([0-9]+).*requests:\ count\ ([0-9]+)\ mean\ [0-9]+\ max\ ([0-9]+) ]]
  echo "$1: a pass max ${BASH_REMATCH[3]} of $4 instructions; start ${BASH_REMATCH[1]} of 36000000"
  (($(stat -c %s answers.bin) == $2 * $3)) || fail "$1: answered by $(stat -c %s answers.bin) bytes"
  ((BASH_REMATCH[3] <= $4 && BASH_REMATCH[1] <= 36000000))
}
expect_cost '\xA5\x99\x00\x00\x34\x2A' 4 112 24000
expect_cost '\xA5\x99\x01\x00\x05\x19' 4 72 10000
expect_cost '=CONFIG,1\r\n?DR\r\n=CONFIG,0\r\n' 2 18 7000
expect_cost '=CONFIG,1\r\n=ROTUNITS,DEG\r\n=CONFIG,0\r\n' 1 33 7000
expect_cost '?BIT\r\n' 4 11 7000
expect_cost '?BIT,2\r\n' 4 13 7000
