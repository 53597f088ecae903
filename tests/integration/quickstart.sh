#!/usr/bin/env bash
# quickstart.sh ROOT: the README's first command, whole, on a recording of 5 Hz: down to the image that gives what the
# host gives. Run again, it makes nothing again. The tool is that of ROOT/build/host, built here if it is not there.
set -euo pipefail
source "$(dirname "$0")/common.sh"
root=$(realpath "${1:?usage: quickstart.sh ROOT}")
enter_scratch
mkdir -p "$root/build/host"
ln -s "$root/build/host" "$scratch/host"

"$root/host_tools/quickstart.sh" 5 "$scratch" 2>&1 | tee "$scratch/said.txt"
(($(grep -c ' frames compared, 0 bytes differ$' "$scratch/said.txt") == 2)) ||
  fail "not both images are compared: $(cat "$scratch/said.txt")"
says "$scratch/said.txt" "297750 frames compared"
"$root/host_tools/quickstart.sh" 5 "$scratch" >"$scratch/again.txt"
grep -F "(nothing has changed since these figures were made)" "$scratch/again.txt"
