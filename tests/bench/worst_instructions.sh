#!/usr/bin/env bash
# worst_instructions.sh [RUNS [SEED]]: searches the model table and the stream with which a sample comes nearest to the
# bound of its cost (SPEC.md, "Cost of a sample"), in instructions counted by QEMU, of the image that
# tests/target/sample_bound.sh builds. Fails if one exceeds it. 200 runs take two minutes of processor time.
set -euo pipefail
cd "$(dirname "$0")/../.."
runs=${1:-200} seed=${2:-1}
found=build/host/worst_instructions
tests/target/sample_bound.sh build/host/firmware_images "$found"
/usr/bin/python3 tests/bench/worst_instructions.py "$found/sample_cost.elf" "$found" 30 9 "$runs" "$seed"
