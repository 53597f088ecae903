#!/usr/bin/env bash
# Package:  Debian 12 r-cran-data.table 1.14.8+dfsg-1, r-cran-bit64 4.0.5-1 (R 4.2.2): mean(), min() and max() by group.
# Expected: a group's mean, minimum and maximum of 64-bit integers are those of the same column without groups.
# Seen:     the grouped mean of negative counts is their sum, and minimum and maximum are swapped. The grouped mean of
#           microsecond stamps a second apart is right for five rows and 6 years late for six. The sum is right, and
#           then its bits are divided as those of a double. No warning. as.numeric() inside mean() works.
# Matters:  fread() reads integers beyond 32 bits, encoder counts and time stamps, as integer64 by itself. Bins by
#           temperature or by minute get wrong times, and an angle that runs backwards gets wrong limits.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian r-base-core=4.2.2.20221110-2 r-cran-data.table=1.14.8+dfsg-1 r-cran-bit64=4.0.5-1
cat >groups.R <<'R'
suppressMessages({ library(data.table); library(bit64) })
show <- function(name, ...) cat(name, sapply(list(...), format), "\n", sep = " ")
counts <- data.table(bin = 1L, count = as.integer64(c(-5, -3, -1)))
with(counts, show("column: mean, min, max", mean(count), min(count), max(count)))
grouped <- counts[, .(mean = mean(count), min = min(count), max = max(count)), by = bin]
with(grouped, show("group:  mean, min, max", mean, min, max))
for (rows in 5:6) {
  stamps <- data.table(bin = 1L, time = as.integer64(1.7e15) + as.integer64(1e6) * (1:rows))
  show(paste(rows, "stamps, column:"), mean(stamps$time))
  show(paste(rows, "stamps, group: "), stamps[, .(mean = mean(time)), by = bin]$mean)
}
show("6 stamps, doubles:", sprintf("%.0f", stamps[, .(mean = mean(as.numeric(time))), by = bin]$mean))
R
stated 'column: mean, min, max -3 -5 -1
group:  mean, min, max -9 -1 -5
5 stamps, column: 1700000003000000
5 stamps, group:  1700000003000000
6 stamps, column: 1700000003500000
6 stamps, group:  1898800131209835
6 stamps, doubles: 1700000003500000' "$(Rscript --vanilla groups.R 2>&1 | sed 's/ *$//')"
