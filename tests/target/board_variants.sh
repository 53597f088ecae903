#!/usr/bin/env bash
# board_variants.sh SOURCE IMAGES FOGCOMP DS18B20 UART.in DIR: every choice of the STM32F405 build makes an image
# that keeps the rules, and the default image holds nothing of those it did not choose. What the emulator lacks (DMA,
# converter) must not stop a board: without its sensor it answers every sample, and marks none valid. A DS18B20 at
# USART 6 it believes. Another board with the same chip, and with a clock for resets, sends the same bytes, on its
# own port, and with a pin of validity; a board that is not there is refused.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
source=$1 images=$2 fogcomp=$3 ds18b20=$4 input=$5 folder=$6
mkdir -p "$folder"

symbols=$(arm-none-eabi-nm -C "$images/stm32f405/fogcomp.elf")
if grep -iE 'thermometer|ds18b20|platinum|crc8|lasting|of_sample' <<<"$symbols"; then
  fail "the default image holds a thermometer, a clock or a pin of validity"
fi

# build OUTPUT TEMPERATURE: an image with these choices.
# Those of a thermometer are lenient (lenient_images.sh), or no rate were valid within the stream.
build() {
  local header=$source/firmware/model/fog_model.h
  [[ $2 == stream ]] || header=$images/lenient/fog_model.h
  image=$folder/$1_$2.elf
  "$source/tests/target/build_variant.sh" "$images" stm32f405 fogcomp "$image" \
    -DFOG_OUTPUT="$1" -DFOG_TEMPERATURE="$2" \
    -DFOG_MODEL_HEADER="$header"
  "$source/tests/budget/forbidden_symbols.sh" "$image"
  echo "$1, $2: $(arm-none-eabi-size "$image" | awk 'NR == 2 { print $1 + $2 }') bytes of flash"
}

build dma stream
"$fogcomp" replay "$images/stm32f405/model/fog_model.h" "$input" -o "$folder/expected.bin"
frames=$(($(stat -c %s "$folder/expected.bin") / 36))
for sensor in ds18b20 pt1000; do
  build polled "$sensor"
  "$source/tests/target/run_uart.sh" netduinoplus2 "$image" "$input" "$folder/out.bin" $((36 * frames))
  validity=$(od -An -v -t u1 -w36 "$folder/out.bin" | awk '{ print $29 }' | sort | uniq -c)
  echo "status bytes of the frames without a sensor: $validity"
  [[ $validity =~ ^\ *$frames\ 0$ ]]
done

image=$folder/pyboard.elf
"$source/tests/target/build_variant.sh" "$images" stm32f405 fogcomp "$image" -DFOG_BOARD=pyboard_v11 \
  -DFOG_RESET_CLOCK=lse -DFOG_SYNC=tov
FOG_OUTPUT_PORT=5 "$source/tests/target/run_uart.sh" netduinoplus2 "$image" "$input" "$folder/out.bin" $((36 * frames))
same_bytes "$folder/expected.bin" "$folder/out.bin"

# The stream says 20 degC; the sensor at the line 42. Rates are valid once it has been read, with its temperature.
mkfifo "$folder/line.in" "$folder/line.out" 2>/dev/null || true
"$ds18b20" "$folder/line.out" "$folder/line.in" 42 &
trap 'kill $! 2>/dev/null || true' EXIT
"$source/tests/target/run_uart.sh" netduinoplus2 "$folder/polled_ds18b20.elf" "$input" "$folder/out.bin" \
  $((36 * frames)) -serial null -serial null -serial "pipe:$folder/line"
temperatures=$(od -An -v -t u1 -w36 "$folder/out.bin" | awk '$29 == 4 { print 256 * $31 + $32 }' | sort | uniq -c)
echo "temperatures of valid frames with a sensor of 42 degC: $temperatures"
[[ $temperatures =~ ^\ *[0-9]+\ 42$ ]]

if cmake -S "$source" -B "$folder/refused" --preset mps2_an386 -DFOG_OUTPUT=dma >"$folder/refused.log" 2>&1; then
  fail "a board without DMA was built for it"
fi
grep -q "has no output_dma" "$folder/refused.log"
if cmake -S "$source" -B "$folder/refused" --preset mps2_an386 -DFOG_OUTPUT=polled -DFOG_SYNC=tov \
  >"$folder/refused.log" 2>&1; then
  fail "a board without a pin of validity was built for it"
fi
grep -q "has no sync_tov" "$folder/refused.log"

for platform in stm32f405 mps2_an386; do
  if cmake -S "$source" -B "$folder/refused_$platform" --preset "$platform" -DFOG_BOARD=none >"$folder/refused.log" \
    2>&1; then
    fail "$platform was built for a board that is not there"
  fi
  grep -q "no board with a $platform" "$folder/refused.log"
done
