#!/usr/bin/env bash
# Package:  Debian 12 libgsl-dev 2.7.1+dfsg-5+deb12u1: gsl_filter_gaussian() of order 1 and 2.
# Expected: order 1 gives the first derivative, 3 for a line of slope 3, and order 2 the second, 0 for a constant.
# Seen:     the kernel is cut off and not scaled again. With 51 samples and alpha = 2.5 the slope is 2.76, with
#           alpha = 1 it is 0.90. The second derivative of a constant 300 is -0.24, and -43.8 with five samples. With
#           alpha = 4 and 51 samples both are nearly right. Order 0 is scaled, and right.
# Matters:  the rate of the temperature is a regressor of every thermal model. It is 8 % too small by the choice of a
#           width alone. The second derivative follows the temperature itself, in kelvin more than in Celsius.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian libgsl-dev=2.7.1+dfsg-5+deb12u1
cat >derivative.c <<'C'
#include <gsl/gsl_filter.h>
#include <stdio.h>
static double at_middle(int samples, double alpha, int order, double from, double slope) {
  gsl_vector *x = gsl_vector_alloc(101), *filtered = gsl_vector_alloc(101);
  for (int i = 0; i < 101; i++) gsl_vector_set(x, i, from + slope * i);
  gsl_filter_gaussian(GSL_FILTER_END_TRUNCATE, alpha, order, x, filtered, gsl_filter_gaussian_alloc(samples));
  return gsl_vector_get(filtered, 50);
}
int main(void) {
  const struct { int samples; double alpha; } widths[] = {{51, 4}, {51, 2.5}, {51, 1}, {5, 1}};
  for (int k = 0; k < 4; k++) {
    const int samples = widths[k].samples;
    const double alpha = widths[k].alpha;
    printf("%d samples, alpha %.1f: constant 300 is %.0f", samples, alpha, at_middle(samples, alpha, 0, 300, 0));
    printf(", slope 3 is %.2f", at_middle(samples, alpha, 1, 0, 3));
    printf(", second derivative of 300 is %.2f\n", at_middle(samples, alpha, 2, 300, 0));
  }
}
C
gcc -O1 derivative.c -lgsl -lgslcblas -lm -o derivative
stated '51 samples, alpha 4.0: constant 300 is 300, slope 3 is 3.00, second derivative of 300 is -0.01
51 samples, alpha 2.5: constant 300 is 300, slope 3 is 2.76, second derivative of 300 is -0.24
51 samples, alpha 1.0: constant 300 is 300, slope 3 is 0.90, second derivative of 300 is -0.34
5 samples, alpha 1.0: constant 300 is 300, slope 3 is 1.25, second derivative of 300 is -43.81' "$(./derivative)"
