#!/usr/bin/env bash
# Package:  Debian 12 r-cran-interp 1.1-3-1 (R 4.2.2): bilinear.grid(), bilinear().
# Expected: a map over 3 temperatures and 5 rates, asked for 3 by 5 points, comes back as it is. A point outside of the
#           map is NA.
# Seen:     bilinear.grid() lays its x over the range of y. With temperatures of -40 to 60 degrees and rates of -100 to
#           100 the rows are those of -100, 0 and 100 degrees. Outside of the map it and bilinear() give 0. No warning.
#           With dx and dy instead of nx and ny, the grid is right.
# Matters:  nx and ny are what one refines a drift map with, and they have defaults. A table made this way has its rows
#           at other temperatures, and a drift of 0 beyond the map looks like a perfect gyro.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian r-base-core=4.2.2.20221110-2 r-cran-interp=1.1-3-1
cat >map.R <<'R'
library(interp)
temperature <- c(-40, 10, 60)
rate <- c(-100, -50, 0, 50, 100)
drift <- outer(temperature, rate, function(t, r) 5 + t / 10 + r / 1000)
show <- function(name, map) for (row in 1:3) cat(name, map$x[row], "degrees:", map$z[row, ], "\n")
show("map,", list(x = temperature, z = drift))
show("nx, ny,", bilinear.grid(temperature, rate, drift, nx = 3, ny = 5))
show("dx, dy,", bilinear.grid(temperature, rate, drift, dx = 50, dy = 50))
cat("bilinear at 61 degrees:", bilinear(temperature, rate, drift, 61, 0)$z, "\n")
R
stated 'map, -40 degrees: 0.9 0.95 1 1.05 1.1
map, 10 degrees: 5.9 5.95 6 6.05 6.1
map, 60 degrees: 10.9 10.95 11 11.05 11.1
nx, ny, -100 degrees: 0 0 0 0 0
nx, ny, 0 degrees: 4.9 4.95 5 5.05 5.1
nx, ny, 100 degrees: 0 0 0 0 0
dx, dy, -40 degrees: 0.9 0.95 1 1.05 1.1
dx, dy, 10 degrees: 5.9 5.95 6 6.05 6.1
dx, dy, 60 degrees: 10.9 10.95 11 11.05 11.1
bilinear at 61 degrees: 0' "$(Rscript --vanilla map.R 2>&1 | sed 's/ *$//')"
