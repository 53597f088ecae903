#!/usr/bin/env bash
# production_line.sh MACHINE FLASH ELF FOGCOMP DIR: from recordings to a gyro that ships, without a compiler: `batch` makes tables,
# a board with the generic image ELF gets one (where a programmer writes it, QEMU's loader does), `health` says that it has the
# model of the sheet's line, and the board sends what `replay` of the table does.
set -euo pipefail
machine=$1 slot=$(($2 + 48 * 1024)) elf=$3 fogcomp=$4 folder=$5
here=$(realpath "$(dirname "$0")")
rm -rf "$folder"
mkdir -p "$folder"
source "$here/board_session.sh"

for gyro in G001 G002; do
  mkdir -p "$folder/gyros/$gyro"
  "$fogcomp" simulate -o "$folder/gyros/$gyro/run.csv" --seed "${gyro#G00}" >/dev/null
done
"$fogcomp" batch "$folder/gyros" -o "$folder/results" --effects bias,bias_temperature,temperature_rate --invalid none --tables >/dev/null
table=$folder/results/tables/G002.bin
IFS=, read -r _ serial _ crc _ <<<"$(grep '"G002"' "$folder/results/tables/sheet.csv")"

printf 'start 20 degC\nsoak 1 min\n' >"$folder/rest.profile"
"$fogcomp" simulate -o "$folder/in.bin" --profile "$folder/rest.profile" --preset paper --rate 200 --format stream --seed 1 >/dev/null
head -c 32000 "$folder/in.bin" >"$folder/short.bin"
"$fogcomp" replay "$table" "$folder/short.bin" -o "$folder/expected.bin" >/dev/null
"$here/run_uart.sh" "$machine" "$elf" "$folder/short.bin" "$folder/out.bin" "$(stat -c %s "$folder/expected.bin")" \
  -device "loader,file=$table,addr=$slot,force-raw=on" | tr -d '\r' | tee "$folder/console"
cmp "$folder/expected.bin" "$folder/out.bin"
grep -q "^model 0x$crc of $serial: good$" "$folder/console"
[[ $serial == G002 ]]

# ask OPTION...: what `health` says of a board with these.
ask() {
  : >"$scratch/console"
  timeout --kill-after=1 60 qemu-system-arm -M "$machine" -display none -monitor none "$@" \
    -serial "unix:$scratch/output,server=on,wait=off" -serial null -serial "file:$scratch/console" -kernel "$elf" \
    </dev/null >"$scratch/log" 2>&1 &
  local qemu=$! deadline=$((SECONDS + 30))
  until grep -q '^image: ' "$scratch/console"; do
    ((SECONDS < deadline)) || { echo "the board does not start" >&2; exit 1; }
    sleep 0.02
  done
  "$fogcomp" health "$scratch/output" --timeout 30 --json | tr -d ' \n' || true
  kill "$qemu"
  wait "$qemu" || true
}
ask -device "loader,file=$table,addr=$slot,force-raw=on" | tee "$folder/health.json"
grep -q "\"model_crc32\":\"$crc\",\"gyro_serial\":\"$serial\"" "$folder/health.json"
grep -qE "\"slots\":\[\{\"finding\":\"good\",\"in_use\":true,\"sequence\":1,\"model_crc32\":\"$crc\",.*\{\"finding\":\"missing\",\"in_use\":false" "$folder/health.json"
ask | tee "$folder/empty.json"
grep -qE '"model_finding":"missing".*"slots":\[\{"finding":"missing","in_use":false' "$folder/empty.json"
