#!/usr/bin/env bash
# quickstart.sh ROOT: the README's first command, whole, on a recording of 5 Hz: down to the image that gives what the
# host gives. Run again, it makes nothing again. The tool is that of ROOT/build/host, built here if it is not there.
set -euo pipefail
root=$(realpath "${1:?usage: quickstart.sh ROOT}")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$root/build/host"
ln -s "$root/build/host" "$scratch/host"

"$root/host_tools/quickstart.sh" 5 "$scratch" 2>&1 | tee "$scratch/said.txt"
(($(grep -c ' frames compared, 0 bytes differ$' "$scratch/said.txt") == 2)) || { echo "not compared" >&2; exit 1; }
grep -q "297750 frames compared" "$scratch/said.txt" || { echo "not the whole recording" >&2; exit 1; }
"$root/host_tools/quickstart.sh" 5 "$scratch" >"$scratch/again.txt"
grep -F "(nothing has changed since these figures were made)" "$scratch/again.txt"
