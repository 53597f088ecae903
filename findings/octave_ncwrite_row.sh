#!/usr/bin/env bash
# Package:  Debian 12 octave-netcdf 1.0.16-2 (octave 7.3.0-2): ncwrite(); the file by ncdump of netcdf-bin 1:4.9.0-3+b1.
# Expected: a row of four samples fills a variable of four, or is refused: it has no second dimension.
# Seen:     only the first sample is written. The other three keep the fill value, and an unlimited time has one record.
#           No error, no warning. A column is written in full.
# Matters:  0:dt:end and most computed series in Octave are rows. The file has the right size, and its samples are gone
#           when somebody opens it. Write counts(:).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian octave=7.3.0-2 octave-netcdf=1.0.16-2 netcdf-bin=1:4.9.0-3+b1
cat >write.m <<'M'
pkg load netcdf
counts = [11 12 13 14];
for name = {"row", "column"}
  nccreate("run.nc", name{1}, "Dimensions", {"sample", 4}, "Datatype", "int16");
end
nccreate("run.nc", "unlimited", "Dimensions", {"time", Inf}, "Datatype", "int16");
ncwrite("run.nc", "row", counts);
ncwrite("run.nc", "column", counts');
ncwrite("run.nc", "unlimited", counts);
M
octave-cli --no-history -q write.m
stated ' row = 11, _, _, _ ;
 column = 11, 12, 13, 14 ;
 unlimited = 11 ;' "$(ncdump run.nc | sed -n '/^data:/,$p' | grep ' = ')"
