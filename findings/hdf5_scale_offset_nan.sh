#!/usr/bin/env bash
# Package:  Debian 12 libhdf5-103-1 1.10.8+repack1-1 (filter "scale-offset"), by python3-h5py 3.7.0-8.
# Expected: a lossy filter that keeps two decimals keeps a NaN, or refuses it.
# Seen:     a NaN comes back as the smallest value of its chunk, even where NaN is the fill value of the data set. An
#           infinity, or -999 as the fill value, comes back as written.
# Matters:  scale-offset is how HDF5 makes temperature columns small, and NaN is how a dropped sample is written. A
#           reader cannot tell the gap from a sample of the coldest temperature within the chunk.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian libhdf5-103-1=1.10.8+repack1-1 python3-h5py=3.7.0-8
cat >filter.py <<'P'
import h5py
import numpy as np

def through_filter(gap, fill):
    temperature = np.linspace(-20, 11, 32)
    temperature[20] = gap
    with h5py.File("run.h5", "w") as file:
        file.create_dataset("t", data=temperature, chunks=(32,), scaleoffset=2, fillvalue=fill)
    with h5py.File("run.h5") as file:
        return file["t"][19:22]

print("gap NaN, fill value 0:", through_filter(np.nan, 0.0))
print("gap NaN, fill value NaN:", through_filter(np.nan, np.nan))
print("gap inf, fill value 0:", through_filter(np.inf, 0.0))
print("gap -999, fill value -999:", through_filter(-999.0, -999.0))
P
stated 'gap NaN, fill value 0: [ -1. -20.   1.]
gap NaN, fill value NaN: [ -1. -20.   1.]
gap inf, fill value 0: [-1. inf  1.]
gap -999, fill value -999: [  -1. -999.    1.]' "$(/usr/bin/python3 filter.py)"
