#!/usr/bin/env bash
# Package:  Debian 12 libgsl-dev 2.7.1+dfsg-5+deb12u1: gsl_movstat_variance(), gsl_movstat_mean(), window of 5 samples.
# Expected: a window without the bad sample has the mean and the variance of its own five samples.
# Seen:     the bad sample is added to running sums and taken out again, but its rounding stays to the end. After a
#           single 2^31 the variance of 100 and 101 counts is 1e-8 instead of 0.3. After 1e17 it is negative, and the
#           mean is 99.8. After NaN both are NaN. gsl_movstat_median() forgets it.
# Matters:  one corrupt word decides what all later samples have as their noise. A gate for outliers built on this
#           variance rejects the rest of the recording. Take bad samples out first.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian libgsl-dev=2.7.1+dfsg-5+deb12u1
cat >moving.c <<'C'
#include <gsl/gsl_movstat.h>
#include <math.h>
#include <stdio.h>
int main(void) {
  const double bad[] = {100, 2147483648.0, 1e17, NAN};
  gsl_vector *counts = gsl_vector_alloc(1000), *moving = gsl_vector_alloc(1000);
  gsl_movstat_workspace *window = gsl_movstat_alloc(5);
  for (int k = 0; k < 4; k++) {
    for (int i = 0; i < 1000; i++) gsl_vector_set(counts, i, i == 20 ? bad[k] : 100 + i % 2);
    printf("sample 20 is %g, at 900:", bad[k]);
    gsl_movstat_variance(GSL_MOVSTAT_END_TRUNCATE, counts, moving, window);
    printf(" variance %.3g", gsl_vector_get(moving, 900));
    gsl_movstat_mean(GSL_MOVSTAT_END_TRUNCATE, counts, moving, window);
    printf(" mean %.1f", gsl_vector_get(moving, 900));
    gsl_movstat_median(GSL_MOVSTAT_END_TRUNCATE, counts, moving, window);
    printf(" median %g\n", gsl_vector_get(moving, 900));
  }
}
C
gcc -O1 moving.c -lgsl -lgslcblas -lm -o moving
stated 'sample 20 is 100, at 900: variance 0.3 mean 100.4 median 100
sample 20 is 2.14748e+09, at 900: variance 1.19e-08 mean 100.4 median 100
sample 20 is 1e+17, at 900: variance -0.3 mean 99.8 median 100
sample 20 is nan, at 900: variance nan mean nan median 100' "$(./moving)"
