#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "judge/at_noise.hpp"
#include "judge/likelihood.hpp"
#include "judge/rivals.hpp"

namespace fogcomp::judge {

/// A set of effects. `log_likelihood`: [0] without something else beside it, [1] with it.
struct EffectSet {
  std::vector<Part> parts;
  double log_prior = 0;
  Beside log_likelihood = kNoLikelihood;

  double likelihood() const { return log_add(log_likelihood[0], log_likelihood[1]); }
  double total() const { return log_prior + likelihood(); }
};

/// Probability that no effect is missing, or one, two, three, before the rows are seen.
inline constexpr std::array<double, 4> kMissingBefore{0.7, 0.25, 0.04, 0.01};

/// Searches sets of up to three effects: each alone in all its shapes; each with all others beside
/// its best shape; the most probable of these with a third.
class SetSearch {
 public:
  /// `rivals` must outlive this.
  explicit SetSearch(const Rivals& rivals);

  /// The empty set, each effect alone in their order, and the sets of several.
  const std::vector<EffectSet>& sets() const { return sets_; }
  const std::vector<AtNoise>& noises() const { return noises_; }
  const Likelihood& likelihood() const { return likelihood_; }
  /// Logarithm of the likelihood of a shape alone, and of nothing in each noise.
  double of_shape(std::size_t effect, std::size_t shape) const;
  const std::vector<double>& of_nothing() const { return of_nothing_; }

 private:
  void weigh_each_alone();
  void weigh_each_in(const Setting& setting, Evidence& evidence) const;
  void add_single_sets();
  void choose_likely_noises();
  double most_likely_in(const Setting& setting) const;
  std::vector<EffectSet> extended(const std::vector<EffectSet>& sets);
  std::vector<EffectSet> with_one_more(const EffectSet& set) const;
  EffectSet joined(const EffectSet& set, double of_shapes, std::size_t effect,
                   const Evidence& evidence) const;
  double log_prior(const std::vector<Part>& parts) const;
  double floor_beside(const EffectSet& set) const;
  double averaging(const std::vector<Part>& parts) const;
  bool may_be_added(const EffectSet& set, std::size_t effect) const;

  const Rivals& rivals_;
  Likelihood likelihood_;
  std::vector<AtNoise> noises_;
  std::vector<Setting> settings_;    // of each noise: without something else, then its sizes
  std::vector<std::size_t> likely_;  // noises in which a set may be likely
  Eigen::MatrixXd likely_weights_;   // their weights of the bands
  Evidence alone_;
  Beside nothing_ = kNoLikelihood;
  std::vector<double> of_nothing_;
  std::vector<EffectSet> sets_;
  double best_ = -HUGE_VAL;  // total of the most probable set
};

}  // namespace fogcomp::judge
