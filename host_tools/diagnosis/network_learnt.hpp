#pragma once

#include <string>
#include <vector>

#include "diagnosis/candidates.hpp"
#include "model/network.hpp"

namespace fogcomp::diagnosis {

/// Smallest explained fraction for which an effect counts as learnt. Less is imitation: a single
/// effect explained a third of |dT/dt|, which is not in the catalogue, and two thirds of learnt
/// slow noise.
constexpr double kLearntShare = 0.8;

/// What a network had learnt, in terms of the catalogue. The network itself is excluded from a
/// diagnosis.
struct NetworkLearnt {
  double rms_dph = 0;  ///< of what it adds, over the rows
  /// Fraction of it, 0..1 (whitened squares), that the model's own effects could not describe.
  double beyond_effects = 0;
  struct Share {
    model::EffectTerm term;  ///< where its shape parameters fit best; no coefficients
    double share = 0;  ///< of what is beyond the effects, 0..1; shares of different effects overlap
  };
  std::vector<Share> effects;  ///< each by itself, the largest first
};

/// Evaluates `network` over the rows of `series`, whose recordings have its inputs, and projects
/// out the model with `project_out_model`. Events are not considered.
NetworkLearnt ask_network(const model::RealNetwork& network, const series::SignalSeries& series,
                          const std::vector<Candidate>& candidates,
                          const ProjectOutModel& project_out_model);

}  // namespace fogcomp::diagnosis
