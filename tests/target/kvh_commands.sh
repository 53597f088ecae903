#!/usr/bin/env bash
# kvh_commands.sh MACHINE PLATFORM IMAGES FOGCOMP MAKE_MODEL IN.bin DIR: an image whose header says so answers the
# lines that drivers of KVH's gyros send, sends no frames in the configuration mode, and reports its built-in tests.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
machine=$1 platform=$2 images=$3 fogcomp=$4 make_model=$5 input=$6 folder=$7
here=$(realpath "$(dirname "$0")")
mkdir -p "$folder"
source "$here/board_session.sh"

"$make_model" "$folder/one.model" 0 bias
"$fogcomp" export "$folder/one.model" -o "$folder/fog_model.h" --sample-rate 100 --rotation delta --kvh-commands
"$here/build_variant.sh" "$images" "$platform" fogcomp "$folder/fogcomp.elf" \
  -DFOG_MODEL_HEADER="$(realpath "$folder/fog_model.h")"

mkfifo "$scratch"/{user,sensor}.{in,out}
: >"$scratch/console"
cat "$scratch/user.out" >"$scratch/sent" &
timeout --kill-after=1 60 qemu-system-arm -M "$machine" -display none -monitor none -serial "pipe:$scratch/user" \
  -serial "pipe:$scratch/sensor" -serial "file:$scratch/console" -kernel "$folder/fogcomp.elf" </dev/null \
    >"$scratch/log" 2>&1 &
exec 7<>"$scratch/user.in" 8<>"$scratch/sensor.in"

patience_s=30
has_sent() { (($(stat -c %s "$scratch/sent") >= $1)); }
wait_for booted

bytes=0
samples() { head -c $((16 * ($1 + 20))) "$input" | tail -c 320 >&8; }
# say LINE [ANSWER]
say() {
  printf '%s\n' "$1" >&7
  [[ ${2-} ]] || { sleep 0.5; return; }
  bytes=$((bytes + ${#2} + 2))
  wait_for has_sent "$bytes"
  [[ $(tail -c "$((${#2} + 2))" "$scratch/sent") == "$2"$'\r' ]] ||
    fail "to $1: $(tail -c 40 "$scratch/sent")"
}
frames() { wait_for has_sent $((bytes += 36 * $1)); }
# tests MESSAGE: the hexadecimal digits that come next, of the built-in tests.
tests() {
  wait_for has_sent $((bytes += ${#1} / 2))
  [[ $(tail -c $((${#1} / 2)) "$scratch/sent" | od -An -v -t x1 | tr -d ' \n') == "$1" ]] ||
    fail "tests: $(tail -c 40 "$scratch/sent" | od -An -v -t x1)"
}

tests fe8100aa7f7f7f7f7f7f23

samples 0
frames 20
printf '?bit\r\n' >&7
tests fe8100aa7f7f7f7f7f7f23
say '=CONFIG,1' CONFIG,1
samples 20
printf '?BIT,2\n' >&7
tests fe8100ab7f7f7f7f7f7f7f7f22
say '?TEMPUNITS' TEMPUNITS,C
say '?ROTFMT' ROTFMT,DELTA
say '=dr,100' DR,100
say '?BAUD' BAUD,921600
say '=ROTFMT,RATE' INVALID,=ROTFMT,RATE
sleep 0.5
say '=CONFIG,0'
samples 40
frames 20
(($(stat -c %s "$scratch/sent") == bytes)) ||
  fail "$(stat -c %s "$scratch/sent") bytes sent, not $bytes"
echo "$machine: $bytes bytes sent as expected"
