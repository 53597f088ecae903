#!/usr/bin/env bash
# Package:  npm netcdfjs 4.0.0; the files by ncgen of Debian 12 netcdf-bin 1:4.9.0-3+b1.
# Expected: a record variable of type short reads as one number for each record.
# Seen:     beside another record variable each record is a pair, the count and the padding to 4 bytes (-32767). Alone,
#           where the format has no padding, reading raises a RangeError. int and double are right.
# Matters:  16-bit counts over an unlimited time are the usual layout of a classic netCDF logger. Flattened, every
#           second sample is -32767, and the time no longer fits the counts.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian netcdf-bin=1:4.9.0-3+b1
npm_packages netcdfjs@4.0.0
ncgen -k classic -o two.nc <<'C'
netcdf two { dimensions: time = UNLIMITED ;
variables: double time(time) ; short counts(time) ;
data: time = 0, 0.5, 1 ; counts = 11, 12, 13 ; }
C
ncgen -k classic -o one.nc <<'C'
netcdf one { dimensions: time = UNLIMITED ;
variables: short counts(time) ;
data: counts = 11, 12, 13 ; }
C
cat >read.mjs <<'J'
import { readFileSync } from 'node:fs';
import { NetCDFReader } from 'netcdfjs';
for (const [file, name] of [['two.nc', 'time'], ['two.nc', 'counts'], ['one.nc', 'counts']]) {
  try {
    console.log(file, name, JSON.stringify(new NetCDFReader(readFileSync(file)).getDataVariable(name)));
  } catch (error) {
    console.log(file, name, error.name);
  }
}
J
stated 'two.nc time [0,0.5,1]
two.nc counts [[11,-32767],[12,-32767],[13,-32767]]
one.nc counts RangeError' "$(node read.mjs)"
