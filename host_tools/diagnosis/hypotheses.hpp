#pragma once

#include <string>
#include <vector>

#include "diagnosis/candidates.hpp"
#include "fit/explained_space.hpp"

namespace fogcomp::diagnosis {

/// Columns of each shape of each candidate in the space.
using RegressorBasis = std::vector<std::vector<series::ColumnRange>>;  // candidate, shape

/// A set of effects, each with one shape, that may be missing. An effect may occur twice: two radii
/// of hysteresis, two lags.
struct Hypothesis {
  struct Part {
    std::size_t candidate = 0;
    std::size_t shape = 0;
  };
  std::vector<Part> parts;
  double chi2_drop = 0;       ///< fall of chi^2
  double log_evidence = 0;    ///< against "nothing is missing", averaged over shapes
  double log_prior = 0;       ///< of this set against a single effect of one coefficient
  double probability = 0;     ///< among all hypotheses
  bool led_by_event = false;  ///< an event explains most of it
  bool free_shape = false;  ///< of temperature and time alone, led by an effect whose shape is free

  bool has(std::size_t candidate) const;
  /// Shape of a candidate that it has: of the first part, if there are two.
  std::size_t shape_of(std::size_t candidate) const;
  /// Number of different effects.
  std::size_t effects() const;
};

/// One of its effects, by its candidate: with the shape of its part, or, where the effect occurs
/// twice, with both shapes, the smaller first.
model::EffectTerm term_in(const Hypothesis& hypothesis, std::size_t candidate,
                          const std::vector<Candidate>& candidates);

/// Column ranges of the parts of a hypothesis, in their order, optionally without one part.
constexpr std::size_t kEveryPart = static_cast<std::size_t>(-1);
std::vector<series::ColumnRange> ranges_of(const RegressorBasis& regressors,
                                           const Hypothesis& hypothesis,
                                           std::size_t left_out = kEveryPart);

/// The candidate whose removal reduces the explained chi^2 most.
std::size_t leading_candidate(const fit::ExplainedSpace& space, const RegressorBasis& regressors,
                              const Hypothesis& hypothesis);

/// Average over the shapes of a candidate, given `others`: its evidence and its best shape.
struct BestShape {
  std::size_t shape = 0;
  double chi2_drop = 0;     ///< with the others, at the best shape
  double log_evidence = 0;  ///< with the others, averaged over shapes
};
BestShape best_shape(const fit::ExplainedSpace& space,
                     const std::vector<series::ColumnRange>& shapes,
                     const std::vector<series::ColumnRange>& others,
                     const Eigen::VectorXd& projection);
/// The same from the chi^2 decrease of each shape, and the number of columns.
BestShape best_of_drops(const std::vector<double>& drops, const std::vector<double>& columns);

/// Sets of one, two or three candidates, most probable first. An event in a set must bring a chi^2
/// of rules::kMinStepChi2Drop.
std::vector<Hypothesis> find_hypotheses(const fit::ExplainedSpace& space,
                                        const std::vector<Candidate>& candidates,
                                        const RegressorBasis& regressors);

}  // namespace fogcomp::diagnosis
