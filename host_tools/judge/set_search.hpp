#pragma once

#include <array>
#include <vector>

#include "judge/likelihood.hpp"
#include "judge/rivals.hpp"

namespace fogcomp::judge {

/// A set of effects. `log_likelihood`: [0] without something else beside it, [1] with it.
struct EffectSet {
  std::vector<Part> parts;
  double log_prior = 0;
  Beside log_likelihood{-HUGE_VAL, -HUGE_VAL};

  double likelihood() const { return log_add(log_likelihood[0], log_likelihood[1]); }
  double total() const { return log_prior + likelihood(); }
};

/// Probability that no effect is missing, or one, two, three, before the rows are seen.
inline constexpr std::array<double, 4> kMissingBefore{0.7, 0.25, 0.04, 0.01};

struct FoundSets {
  Likelihood likelihood;
  std::vector<AtNoise> noises;
  std::vector<EffectSet> sets;     ///< the empty set, each effect alone in order, those of several
  std::vector<double> of_shapes;   ///< logarithm of the likelihood of each of all shapes alone
  std::vector<double> of_nothing;  ///< and of nothing in each noise
};

/// Searches sets of up to three effects: each alone in all its shapes; each with all others beside
/// its best shape; the most probable of these with a third.
FoundSets search_sets(const Rivals& rivals);

}  // namespace fogcomp::judge
