#!/usr/bin/env bash
# flash_commands.sh TOOL IMAGES: the commands behind the build's flash targets, as the build gives them, are ones that
# the installed TOOL understands, and write the image to where it runs. No board is touched, even if one is connected.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
tool=$1 images=$2/stm32f405
command -v "$tool" >/dev/null || { echo "skipped: no $tool"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# The image begins with a stack in RAM and an entry in flash, and loads where its first word runs.
read -r stack entry < <(od -An -t x4 -N 8 "$images/fogcomp.bin")
address=$(arm-none-eabi-readelf -lW "$images/fogcomp.elf" | awk '$1 == "LOAD" { print $4; exit }')
echo "image at $address, stack $stack, entry $entry"
[[ $address == 0x08000000 && $stack == 2000* && $entry == 0800* ]]

# told TARGET: what the tool says when it gets the arguments of the build's TARGET, changed so that no board is found.
told() {
  local command
  command=$(ninja -C "$images" -t commands "$1" | tail -n 1)
  echo "\$ ${command#*&& }"
  PATH=$scratch:$PATH bash -c "$command" 2>&1 || true
}

# stand_in: a program of the tool's name that runs it with what is told on standard input before the arguments.
real=$(command -v "$tool")
stand_in() {
  printf '#!/usr/bin/env bash\nexec %s %s "$@"\n' "$real" "$1" >"$scratch/$tool"
  chmod +x "$scratch/$tool"
}

case $tool in
openocd)
  # The adapter's and the part's files are read, then what would reach the board only says so.
  cat >"$scratch/dry.cfg" <<'TCL'
proc init {} { echo "would init" }
proc reset {args} { echo "would reset $args" }
proc poll {args} {}
proc flash {args} { echo "would flash $args" }
proc verify_image {args} { echo "would verify $args" }
set options 0x0FFFAAED
proc mww {address value} {
  global options
  echo "would write $address [format 0x%08X $value]"
  if {$address == 0x40023C14} { set options $value }
}
proc mrw {address} { global options; return $options }
TCL
  cat >"$scratch/openocd" <<STAND_IN
#!/usr/bin/env bash
before=()
while [[ \$1 != -c ]]; do before+=("\$1"); shift; done
exec "$real" "\${before[@]}" -f "$scratch/dry.cfg" "\$@"
STAND_IN
  chmod +x "$scratch/openocd"
  said=$(told flash)
  echo "$said"
  [[ $said == *"would flash write_image erase fogcomp.elf"$'\n'* && $said == *"would verify fogcomp.elf"* &&
    $said == *"would reset run"* ]] || fail "flash: not what it ought to do"
  said=$(told brown_out_reset)
  echo "$said"
  # As the part is delivered, but for BOR_LEV (bits 2, 3) 0, the lock (0) open and the start bit (1).
  [[ $said == *"would write 0x40023C08 0x08192A3B"*"would write 0x40023C08 0x4C5D6E7F"*"option bytes: 0x0FFFAAE2"* ]] ||
    fail "brown_out_reset: not what it ought to write"
  ;;
st-flash)
  stand_in '--serial 0000000000000000000000FF'
  said=$(told flash_st)
  echo "$said"
  [[ $said == *"st-flash --reset write fogcomp.bin $address"* && $said == *"Couldn't find any ST-Link"* ]] ||
    fail "flash_st: not understood"
  stand_in '--mistyped'
  [[ $(told flash_st) == *"invalid command line"* ]] || fail "a wrong option was not noticed"
  ;;
dfu-util)
  stand_in '--serial none-such'
  said=$(told flash_dfu)
  echo "$said"
  [[ $said == *"-s $address:leave -D fogcomp.bin"* && $said == *"No DFU capable USB device"* ]] ||
    fail "flash_dfu: not understood"
  stand_in '--mistyped'
  [[ $(told flash_dfu) == *"unrecognized option"* ]] || fail "a wrong option was not noticed"
  ;;
*)
  fail "no such tool: $tool"
  ;;
esac
