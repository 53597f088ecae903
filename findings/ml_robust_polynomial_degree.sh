#!/usr/bin/env bash
# Package:  npm ml-regression-robust-polynomial 3.0.2, beside ml-regression-polynomial 4.0.0.
# Expected: degree 1 is a line, as in ml-regression-polynomial: 2 + 3 x, whatever one outlier says.
# Seen:     "degree" counts the coefficients. Degree 1 is a constant, and that constant is one of the samples, another
#           one at each run. Degree 2 is the line. The fit itself says degree 1, too.
# Matters:  a bias over temperature fitted robustly "of degree 1" has no slope at all, and changes from run to run.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
npm_packages ml-regression-robust-polynomial@3.0.2 ml-regression-polynomial@4.0.0
cat >line.mjs <<'J'
import { PolynomialRegression } from 'ml-regression-polynomial';
import { RobustPolynomialRegression } from 'ml-regression-robust-polynomial';
const x = Array.from({ length: 20 }, (_, i) => i);
const exact = x.map((t) => 2 + 3 * t);
const y = exact.map((value, i) => (i === 7 ? 73 : value));
const shown = (fit) => fit.coefficients.map((value) => value.toFixed(2)).join(' ');
const fits = (degree) => Array.from({ length: 10 }, () => new RobustPolynomialRegression(x, y, degree));
console.log('plain, degree 1:', shown(new PolynomialRegression(x, exact, 1)));
const [first, second] = [fits(1), fits(2)];
console.log(`robust, degree ${first[0].degree}:`, `${first[0].coefficients.length} coefficient,`,
  `a sample: ${first.every((fit) => y.includes(fit.coefficients[0]))},`,
  `the same ten times: ${new Set(first.map(shown)).size === 1}`);
console.log(`robust, degree ${second[0].degree}:`, [...new Set(second.map(shown))].join(' or '));
J
stated 'plain, degree 1: 2.00 3.00
robust, degree 1: 1 coefficient, a sample: true, the same ten times: false
robust, degree 2: 2.00 3.00' "$(node line.mjs)"
