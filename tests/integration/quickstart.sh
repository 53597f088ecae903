#!/usr/bin/env bash
# quickstart.sh ROOT BUILD: the README's first command, whole, on a recording of 5 Hz: down to the image that gives what
# the host gives. Run again, it makes nothing again.
set -euo pipefail
root=${1:?usage: quickstart.sh ROOT BUILD}
build=$(realpath "${2:?usage: quickstart.sh ROOT BUILD}")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
ln -s "$build" "$scratch/host" # the tool is built already

"$root/host_tools/quickstart.sh" 5 "$scratch" 2>&1 | tee "$scratch/said.txt"
(($(grep -c ' frames compared, 0 bytes differ$' "$scratch/said.txt") == 2)) || { echo "not compared" >&2; exit 1; }
grep -q "297750 frames compared" "$scratch/said.txt" || { echo "not the whole recording" >&2; exit 1; }
"$root/host_tools/quickstart.sh" 5 "$scratch" >"$scratch/again.txt"
grep -F "(nothing has changed since these figures were made)" "$scratch/again.txt"
