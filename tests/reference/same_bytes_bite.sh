#!/usr/bin/env bash
# same_bytes_bite.sh FOGCOMP SOURCE: same_bytes.sh finds a fault in each part of the reference, planted one at a time in a
# copy of it: by the golden vectors, and without them by the core's answers to random models.
set -euo pipefail
fogcomp=$(realpath "$1") source=$(realpath "$2")
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
mkdir "$copy/tests"
failures=0

# found BY FILE FROM TO: a difference is, no program that breaks off.
found() {
  rm -rf "$copy/tests"/*
  cp -r "$source"/tests/{reference,golden,integration} "$copy/tests/"
  "$source/tests/proof/plant.py" "$copy/tests/reference/$2" "$3" "$4"
  # shellcheck disable=SC2016
  [[ $1 == vectors ]] ||
    "$source/tests/proof/plant.py" "$copy/tests/reference/same_bytes.sh" 'python3 "$here/reference.py" --vectors' true
  if ! "$copy/tests/reference/same_bytes.sh" "$fogcomp" "$copy" >"$copy/said.txt" 2>&1 &&
    grep -qE ' instead of |core and reference differ|_dear.bin|_fits.bin' "$copy/said.txt" &&
    ! grep -q Traceback "$copy/said.txt"; then
    echo "found by $1: $2: $4"
  else
    echo "FAILED: not found by $1: $2: $4: $(tail -n 3 "$copy/said.txt")"
    failures=$((failures + 1))
  fi
}
# plant FILE FROM TO
plant() {
  found vectors "$@"
  found models "$@"
}

plant arithmetic.py '(x + (1 << (n - 1))) >> n' 'x >> n'
plant functions.py '_symmetric(x), 1)' '_symmetric(x), 2)'
plant flags.py 'DENOISED_INVALID = 1 << 11' 'DENOISED_INVALID = 1 << 12'
plant samples.py '39 * limit // 40' '38 * limit // 40'
plant thermal.py '* self.decay, 13)' '* self.decay, 14)'
plant effects.py '(20 << 16)' '(19 << 16)'
plant expressions.py 'sat32(abs(b))' 'sat32(b)'
plant network.py 'clamp(off, -each.reach, each.reach)' 'off'
plant denoiser.py 'self.valid[-1] = False' 'pass'
plant course.py 'self.since_good + 1' 'self.since_good + 2'
plant pipeline.py 'doubtful_left = self.denoiser.delay + 1' 'doubtful_left = self.denoiser.delay'
plant frames.py 'frames_before % 128' '(frames_before + 1) % 128'
found models stream.py 'reserved != 0 or status > 3' 'status > 3'
found models cost.py '36 * len(table.network.neurons)' '26 * len(table.network.neurons)'
exit $((failures > 0))
