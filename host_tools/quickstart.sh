#!/usr/bin/env bash
# The main job from nothing, on Debian 12: sets the machine up, builds tool and firmware, records a
# simulated gyro in a chamber, fits a drift model, builds the flash image with it, and plays the
# recording through that image in QEMU and through the same code on this computer.
# Run again, it does only what has changed since.
#
# quickstart.sh [--page] [RATE [BUILD]]: samples per second of the recording (200), folder of what is built (build).
# --page builds the engine of `fogcomp workbench` as well: emscripten, 0.8 GB of packages and some 5 min more.
set -euo pipefail
cd "$(dirname "$0")/.."
source cmake/bootstrap/packages.sh

workbench=()
if [[ ${1:-} == --page ]]; then
  build_packages+=(emscripten zopfli)
  workbench=(-DFOG_WORKBENCH=ON)
  shift
fi
[[ ${1:-} =~ ^[0-9.]*$ ]] || { sed -n '7,8s/^# //p' "$0" >&2; exit 2; }

rate=${1:-200}
build=${2:-build}
here=$build/quickstart
fogcomp=$build/host/fogcomp
image=$build/stm32f405/fogcomp
run=$here/run_${rate}_hz.bin
model=$here/gyro.model
header=$here/fog_model.h
uart_frames=2000

step() { printf '\n== %s\n' "$1"; }

# quietly LOG COMMAND...: keeps a long output in LOG and shows it only where it failed.
quietly() {
  local log=$1
  shift
  "$@" >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
}

# bytes_that_differ A B: how many, length included.
bytes_that_differ() {
  local a b common differ
  a=$(stat -Lc %s "$1")
  b=$(stat -Lc %s "$2")
  common=$((a < b ? a : b))
  differ=$(cmp -l -n "$common" "$1" "$2" | wc -l) || true
  echo $((differ + a + b - 2 * common))
}

step "packages"
require_packages "${build_packages[@]}" || exit 2
echo "all there"
mkdir -p "$here"

step "host tool"
host=$(realpath -m "$build/host") # CMake takes a link to the folder for another one
[[ -f $host/build.ninja && ${#workbench[@]} == 0 ]] ||
  quietly "$here/configure.log" cmake --preset host -B "$host" "${workbench[@]}"
quietly "$here/build.log" cmake --build "$host" --target fogcomp fogcomp_manual
echo "$fogcomp"

step "recording: the reference paper's chamber programme, sampled at $rate Hz as the board sees it"
if [[ ! $run -nt $fogcomp ]]; then
  "$fogcomp" simulate -o "$run" --profile paper --preset paper --rate "$rate" --format stream --seed 1
fi
ls -l "$run" | awk '{printf "%s: %d samples\n", $NF, $5 / 16}'

step "model: physical effects, then a network on what they leave"
"$fogcomp" fit "$run" --rate "$rate" -o "$model" --effects bias,bias_temperature:order=2,temperature_rate --network 6

step "before and after, 10 s means"
"$fogcomp" compare "$model" "$run" --rate "$rate"

step "flash image with these weights"
"$fogcomp" export "$model" -o "$header" --sample-rate "$rate"
quietly "$here/configure_firmware.log" cmake --preset stm32f405 -B "$build/stm32f405" \
  -DFOG_MODEL_HEADER="$(realpath "$header")"
quietly "$here/build_firmware.log" cmake --build "$build/stm32f405"
tests/budget/check_budgets.sh tests/budget/budgets.txt "$build" stm32f405/fogcomp.elf
ls "$image".elf "$image".bin "$image".hex

step "the same recording through the image and through this computer"
bench=$here/bench
result=$bench/result.txt
inputs=$(cat "$header" "$image.elf" "$image"_bulk.elf "$fogcomp" | cksum)
if [[ -f $result && $result -nt $run && $(head -n 1 "$result") == "$inputs" ]]; then
  echo "(nothing has changed since these figures were made)"
else
  mkdir -p "$bench"
  {
    echo "$inputs"
    "$fogcomp" replay "$header" "$run" -o "$bench/expected.bin" >&2
    ln -sf "$(realpath "$run")" "$bench/in.bin"
    FOG_QEMU_TIMEOUT_S=1200 tests/target/run_bulk.sh netduinoplus2 \
      "$image"_bulk.elf "$bench" >&2
    frames=$(($(stat -Lc %s "$run") / 16))
    echo "whole recording, image in bulk:  $frames frames compared," \
      "$(bytes_that_differ "$bench/expected.bin" "$bench/out.bin") bytes differ"

    head -c $((16 * uart_frames)) "$run" >"$bench/uart_in.bin"
    "$fogcomp" replay "$header" "$bench/uart_in.bin" -o "$bench/uart_expected.bin" >&2
    tests/target/run_uart.sh netduinoplus2 "$image.elf" "$bench/uart_in.bin" "$bench/uart_out.bin" \
      "$(stat -c %s "$bench/uart_expected.bin")" >&2
    echo "its start, booted image by USART: $uart_frames frames compared," \
      "$(bytes_that_differ "$bench/uart_expected.bin" "$bench/uart_out.bin") bytes differ"
  } >"$result.new"
  mv "$result.new" "$result"
  rm -f "$bench/expected.bin" "$bench/out.bin" # 430 MB each
fi
tail -n +2 "$result"
if grep -qv ' 0 bytes differ$' <(tail -n +2 "$result"); then
  echo "host and board disagree" >&2
  exit 1
fi
