#!/usr/bin/env bash
# Package:  npm h5wasm 0.10.3 (HDF5 2.0.0 in WebAssembly); the file by Debian 12 python3-h5py 3.7.0-8.
# Expected: a data set whose compression is not built in ("lzf", one of h5py's three) raises an error.
# Seen:     `value` returns an array of the right type and length without any exception. Its numbers are not those of
#           the file; only the HDF5 library's own trace on stderr tells. gzip is read right.
# Matters:  a page that reads a recording compressed with h5py's fast filter plots rates nobody measured. Ask `filters`
#           first and refuse what is not known.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian python3-h5py=3.7.0-8
npm_packages h5wasm@0.10.3
/usr/bin/python3 - <<'P'
import h5py
import numpy as np
with h5py.File("run.h5", "w") as file:
    for compression in ("gzip", "lzf"):
        file.create_dataset(compression, data=np.arange(1000) + 0.5, chunks=(100,), compression=compression)
        assert (file[compression][:] == np.arange(1000) + 0.5).all()
P
cat >read.mjs <<'J'
import h5wasm from 'h5wasm/node';
await h5wasm.ready;
const file = new h5wasm.File('run.h5', 'r');
for (const name of ['gzip', 'lzf']) {
  try {
    const value = file.get(name).value;
    const right = value.filter((x, i) => x === i + 0.5).length;
    console.log(`${name}: ${value.length} numbers,`, right === 1000 ? 'all right' : 'not the data');
  } catch (error) {
    console.log(`${name}: ${error.message}`);
  }
}
J
stated 'gzip: 1000 numbers, all right
lzf: 1000 numbers, not the data' "$(node read.mjs 2>trace.log)"
grep -m1 'is not registered' trace.log
