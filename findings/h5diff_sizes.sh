#!/usr/bin/env bash
# Package:  Debian 12 hdf5-tools 1.10.8+repack1-1: h5diff; the files by python3-h5py 3.7.0-8.
# Expected: exit code 0 where two files hold the same, and 1 where a data set is shorter, or of another shape or type.
# Seen:     for another length, shape or type it is 0, also where the two data sets are named. "Some objects are not
#           comparable" is printed, and nothing at all with -q. Other values, and a missing data set, give 1.
# Matters:  h5diff is what a regression test of recordings calls. It passes when the second half is missing, or when a
#           rate has become whole counts. Compare sizes and types first.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian hdf5-tools=1.10.8+repack1-1 python3-h5py=3.7.0-8
/usr/bin/python3 - <<'P'
import h5py
import numpy as np

rate = np.arange(1000) / 7
others = {"run": rate, "half": rate[:500], "shape": rate.reshape(2, 500), "counts": rate.astype(int)}
others["values"] = rate + 1
for name, data in others.items():
    with h5py.File(name + ".h5", "w") as file:
        file["rate"] = data
with h5py.File("other.h5", "w") as file:
    file["angle"] = rate
P
compare() {
  local exit_code=0 quiet=0
  h5diff "$@" >said.txt 2>&1 || exit_code=$?
  h5diff -q "$@" >quiet.txt 2>&1 || quiet=$?
  echo "$*: exit $exit_code, $(wc -l <said.txt) lines; with -q exit $quiet, $(wc -l <quiet.txt) lines"
}
stated 'run.h5 run.h5: exit 0, 0 lines; with -q exit 0, 0 lines
run.h5 half.h5: exit 0, 4 lines; with -q exit 0, 0 lines
run.h5 shape.h5: exit 0, 4 lines; with -q exit 0, 0 lines
run.h5 counts.h5: exit 0, 4 lines; with -q exit 0, 0 lines
run.h5 values.h5: exit 1, 2 lines; with -q exit 1, 0 lines
run.h5 other.h5: exit 1, 0 lines; with -q exit 1, 0 lines
run.h5 half.h5 /rate /rate: exit 0, 4 lines; with -q exit 0, 0 lines' "$(
  for other in run half shape counts values other; do compare run.h5 "$other.h5"; done
  compare run.h5 half.h5 /rate /rate
)"
