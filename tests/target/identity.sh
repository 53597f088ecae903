#!/usr/bin/env bash
# identity.sh MACHINE PLATFORM BOARD IMAGES FOGCOMP MAKE_MODEL IN.bin DIR: a board says on its console and to `fogcomp
# health` which firmware it runs, which image and whose model; one that is bound to another processor gives no valid
# rate, and says why.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
machine=$1 platform=$2 board=$3 images=$4 fogcomp=$5 make_model=$6 input=$7 folder=$8
here=$(realpath "$(dirname "$0")")
mkdir -p "$folder"
source "$here/board_session.sh"

"$make_model" "$folder/one.model" 0 bias
# ask NAME OPTION...: NAME.console and NAME.json of an image of that model, exported so.
ask() {
  local name=$1
  shift
  "$fogcomp" export "$folder/one.model" -o "$folder/$name.h" --invalid none "$@" >/dev/null
  "$here/build_variant.sh" "$images" "$platform" fogcomp "$folder/$name.elf" \
    -DFOG_MODEL_HEADER="$(realpath "$folder/$name.h")"
  rm -f "$scratch"/{output,sensor.in,sensor.out}
  mkfifo "$scratch/sensor.in" "$scratch/sensor.out"
  : >"$scratch/console"
  timeout --kill-after=1 120 qemu-system-arm -M "$machine" -display none -monitor none \
    -serial "unix:$scratch/output,server=on,wait=off" -serial "pipe:$scratch/sensor" \
    -serial "file:$scratch/console" -kernel "$folder/$name.elf" </dev/null >"$scratch/log" 2>&1 &
  local qemu=$!
  wait_for booted
  head -c 16000 "$input" >"$scratch/sensor.in" &
  sleep 1
  "$fogcomp" health "$scratch/output" --timeout 30 --json | tr -d ' \n' >"$folder/$name.json" || true
  "$fogcomp" health "$scratch/output" --timeout 30 | tee "$folder/$name.txt" || true
  tr -d '\r' <"$scratch/console" >"$folder/$name.console"
  cat "$folder/$name.console"
  kill "$qemu"
  wait "$qemu" || true
}
expect() { grep -qE "$2" "$folder/$1" || { echo "$1 lacks: $2" >&2; cat "$folder/$1" >&2; exit 1; }; }

ask mine --serial FOG-0042
crc=$(sed -nE 's/.*CRC-32 ([0-9a-f]{8}),.*/\1/p' "$folder/mine.h")
sources=$(sed -nE 's/.*FOG_BUILD_SOURCES 0x([0-9a-f]{8})u/\1/p' "$images/variants/$platform/identity/build_identity.h")
expect mine.console "^fogcomp $board ready"
expect mine.console "^firmware [0-9.]+ 0x$sources, processor 0x0{8} 0x0{8} 0x0{8}$"
expect mine.console "^model 0x$crc of FOG-0042: good$"
expect mine.json "\"firmware_sources\":\"$sources\""
expect mine.json "\"model_crc32\":\"$crc\",\"gyro_serial\":\"FOG-0042\""
expect mine.json '"healthy":true'
seal=$(arm-none-eabi-objcopy -O binary -j .seal "$folder/mine.elf" /dev/stdout | od -An -t x4 | tr -d ' ')
expect mine.json "\"image_seal\":\"$seal\""

ask bound --serial FOG-0043 --uid 00340051573550122032394d
expect bound.console '^model 0x0{8}: of another board$'
expect bound.json '"healthy":false'
expect bound.json '"model_finding":"ofanotherboard"'
[[ $(sed -nE 's/.*"samples":([0-9]+),"invalid_rates":([0-9]+).*/\1 \2/p' "$folder/bound.json") =~ \
  ^([1-9][0-9]*)\ ([0-9]+)$ ]]
((BASH_REMATCH[1] == BASH_REMATCH[2])) || fail "a rate was valid"
! grep -q "\"image_seal\":\"$seal\"" "$folder/bound.json"
