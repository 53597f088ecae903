#!/usr/bin/env bash
# flip_bits.sh PROGRAMS MACHINE ELF boot|running MODEL CHECKER REST SEED: flips bits in the product image ELF on QEMU's
# MACHINE (PROGRAMS: the folder of boot_flips and running_flips). Of the model table MODEL bits, of the code that checks
# and that forms frames CHECKER bits, of everything in flash REST bits, drawn with SEED; `all` is every bit.
# boot: each flip is one boot, none of which may give a rate marked valid. running: each flip, of flash and as many of
# the constants in RAM as of the model, must be found within 10 s of samples.
set -euo pipefail
(($# == 8)) || { sed -n '2,6s/^# //p' "$0" >&2; exit 2; }
programs=$1 machine=$2 elf=$3 mode=$4 model=$5 checker=$6 rest=$7 seed=$8
symbols=$(arm-none-eabi-nm -S -C "$elf")

# areas NAME COUNT REGEX: all symbols that match, as areas; of more than one, COUNT bits of each.
areas() {
  local found
  found=$(grep -E "^[0-9a-f]+ [0-9a-f]+ . ($3)" <<<"$symbols" | sort -u -k1,1 |
    awk -v name="$1" -v count="$2" '{ printf "%s:0x%s:0x%s:%s\n", name, $1, $2, count }')
  [[ $found ]] || { echo "no symbol $3 in $elf" >&2; exit 1; }
  echo "$found"
}
address_of() { awk -v name="$1" '$3 == name { print "0x" $1 }' <(arm-none-eabi-nm "$elf"); }

start=$(address_of fog_image_start)
end=$(address_of fog_image_end)
checkers='fog::app::SelfTest::|fog::SealedScan::|fog::crc|fog::\(anonymous namespace\)::(kTable|frame_crc|sealed_crc)|fog::encode_(kvh|compact)_frame|fog::app::run\(|fog_reset_handler'
mapfile -t planned < <(
  areas "model" "$model" '(.*::)?fog_model$'
  areas "checker's code" "$checker" "$checkers"
  echo "any of the image:$start:$((end - start)):$rest"
  [[ $mode == boot ]] || areas "constants in RAM" "$model" 'fog::app::model\(\)::instance'
)
case $mode in
  boot) "$programs/boot_flips" "$machine" "$elf" "$seed" 120 "${planned[@]}" ;;
  running) "$programs/running_flips" "$machine" "$elf" "$seed" 2000 "${planned[@]}" ;;
  *) echo "neither boot nor running: $mode" >&2 && exit 2 ;;
esac
