#!/usr/bin/env bash
# generic_image.sh MACHINE FLASH IMAGES FOGCOMP MAKE_MODEL DIR: the generic image of the folder IMAGES, with the
# tables of several models in the slots of the flash that begins at FLASH, sends what `fogcomp replay` of the model
# does, to the byte: every effect, expression and network input; a denoiser of six levels; none. It uses the newest
# intact table that it has room for, and with none answers every sample with a rate that is not valid.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
machine=$1 flash=$2 images=$(realpath "$3") fogcomp=$4 make_model=$5 folder=$6
here=$(realpath "$(dirname "$0")")
mkdir -p "$folder"
folder=$(realpath "$folder")
slots=($((flash + 48 * 1024)) $((flash + 64 * 1024)))

"$make_model" "$folder/all.model" 4 all 'burst=T*T*dTdt' 'late=lag(T,300)-play(T,?r[2,9])' \
  'start=exp(-t/1200)*sin(T2/9)'
"$fogcomp" simulate -o "$folder/run.csv" --rate 2 --columns all --latitude 34
board=(--extension --output both --sample-rate 2 --allow-error)
fit() { "$fogcomp" fit "$folder/run.csv" -o "$folder/$1.model" --effects bias,temperature_rate "${@:2}" >/dev/null; }
fit six --levels 6
fit none --levels 0
for name in all six none; do
  "$fogcomp" export "$folder/$name.model" -o "$folder/$name.h" "${board[@]}" >/dev/null
  for sequence in 1 2; do
    "$fogcomp" export "$folder/$name.model" --format table -o "$folder/$name$sequence.bin" \
      --sequence "$sequence" "${board[@]}" >/dev/null
  done
done
"$fogcomp" stream "$folder/all.h" "$folder/run.csv" -o "$folder/whole.bin"
head -c 400000 "$folder/whole.bin" >"$folder/in.bin"

# sends TABLE0 TABLE1: what the image sends with these in its slots (- for none).
sends() {
  local options=() slot
  for slot in 0 1; do
    shift_to=$((slot + 1))
    [[ ${!shift_to} == - ]] || options+=(-device "loader,file=${!shift_to},addr=${slots[slot]},force-raw=on")
  done
  rm -f "$folder/out.bin"
  "$here/run_semihosted.sh" "$machine" "$images/fogcomp_bulk.elf" "$folder" "${options[@]}"
}
# expect WHAT MODEL TABLE0 TABLE1
expect() {
  sends "$3" "$4"
  "$fogcomp" replay "$folder/$2.h" "$folder/in.bin" -o "$folder/expected.bin"
  same_bytes "$folder/expected.bin" "$folder/out.bin"
  "$fogcomp" replay "$folder/${2}1.bin" "$folder/in.bin" -o "$folder/expected.bin"
  same_bytes "$folder/expected.bin" "$folder/out.bin"
  echo "$machine, $1: $(stat -c %s "$folder/out.bin") bytes compared, 0 differ"
}
for name in all six none; do expect "$name" "$name" "$folder/${name}1.bin" -; done
expect "the newest, in slot 0" all "$folder/all2.bin" "$folder/six1.bin"
expect "the newest, in slot 1" six "$folder/all1.bin" "$folder/six2.bin"
head -c 300 "$folder/six2.bin" >"$folder/cut.bin"
expect "the newest is cut off" all "$folder/all1.bin" "$folder/cut.bin"
"$fogcomp" export "$folder/six.model" --format table -o "$folder/bound.bin" --sequence 3 \
  --uid 00340051573550122032394d "${board[@]}" >/dev/null
expect "the newest is of another board" all "$folder/all1.bin" "$folder/bound.bin"

sends - -
answered=$(($(stat -c %s "$folder/out.bin") / 36))
valid=$(od -An -v -t u1 -w36 "$folder/out.bin" | awk '$29 != 0' | wc -l)
echo "$machine, no table: $answered samples answered, $valid rates valid"
((answered > 7000 && valid == 0))
