#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

// Tests of claims about probabilities, by the binomial distribution.
namespace fog::test {

/// Probability that an event of probability `p` happens `count` times or more in `trials`.
inline double probability_of_at_least(int count, int trials, double p) {
  if (count <= 0) return 1;
  if (p <= 0) return 0;
  double sum = 0;
  for (int k = count; k <= trials; ++k) {
    sum += std::exp(std::lgamma(trials + 1) - std::lgamma(k + 1) - std::lgamma(trials - k + 1) +
                    k * std::log(p) + (trials - k) * std::log1p(-std::min(p, 1 - 1e-12)));
  }
  return std::min(1.0, sum);
}

/// For stated probabilities ("noise alone would look like this with probability p") of cases with
/// noise alone: none may be too small, i.e. P(p <= x) <= x for every x. Fails if k of n values lie
/// below some x with a probability below 1 / (1000 n): a correct tool fails at most once in 1000
/// times. With n = 60 it refutes a stated 0.1 % that occurs in 10 % of the cases 86 times in 100, a
/// stated 0.01 % that occurs in 10 % (5 %) 95 (58) times.
inline void expect_chances_are_true(std::vector<double> p) {
  std::sort(p.begin(), p.end());
  const auto n = static_cast<int>(p.size());
  ASSERT_GE(n, 12);
  for (int k = 1; k <= n; ++k) {
    const double x = p[static_cast<std::size_t>(k) - 1];
    EXPECT_GE(probability_of_at_least(k, n, x), 1e-3 / n)
        << k << " of " << n << " chances are " << x << " or less";
  }
}

}  // namespace fog::test
