#!/usr/bin/env bash
# Package:  Debian 12 libstatistics-linefit-perl 0.07-3: varianceOfEstimates(), beside lm() of r-base-core
#           4.2.2.20221110-2.
# Expected: the variances of intercept and slope are those that every textbook and R's lm() have.
# Seen:     they are 5 and 7 times too small. The squared residual of a sample is taken as the variance of that sample.
#           Samples that are next to the line by chance count most. sigma() and tStatistics() are right.
# Matters:  the uncertainty of a drift over temperature is 2.7 times too small. A slope that is noise looks significant,
#           and a weighted mean of several runs trusts the one with a sample on the line.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian libstatistics-linefit-perl=0.07-3 r-base-core=4.2.2.20221110-2
printf '%s\n' 2.5 4.3 8.3 11.9 12.9 17.4 19.8 23.8 25.4 28.7 >rate.txt
cat >fit.pl <<'P'
use strict;
use warnings;
use Statistics::LineFit;
chomp(my @rate = <STDIN>);
my $line = Statistics::LineFit->new();
$line->setData([0 .. 9], \@rate);
printf "LineFit: slope %.4f, sigma %.3f, ", ($line->coefficients())[1], $line->sigma();
printf "t of slope %.2f, variances %.4f %.5f\n", ($line->tStatistics())[1], $line->varianceOfEstimates();
P
cat >fit.R <<'R'
rate <- scan("rate.txt", quiet = TRUE)
line <- summary(lm(rate ~ seq(0, 9)))
cat(sprintf("lm: slope %.4f, sigma %.3f, ", coef(line)[2, 1], line$sigma))
cat(sprintf("t of slope %.2f, variances %.4f %.5f\n", coef(line)[2, 3], coef(line)[1, 2]^2, coef(line)[2, 2]^2))
R
stated 'LineFit: slope 2.9648, sigma 0.710, t of slope 37.90, variances 0.0374 0.00084
lm: slope 2.9648, sigma 0.710, t of slope 37.90, variances 0.1744 0.00612' "$(
  perl fit.pl <rate.txt
  Rscript --vanilla fit.R
)"
