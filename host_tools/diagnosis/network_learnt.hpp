#pragma once

#include <string>
#include <vector>

#include "diagnosis/candidates.hpp"
#include "model/network.hpp"

namespace fogcomp::diagnosis {

/// Least share that makes an effect what a network had learnt. Less is imitation: of |dT/dt|, which
/// is not in the catalogue, a single effect explained a third, of learnt slow noise two thirds.
constexpr double kLearntShare = 0.8;

/// What a network had learnt, in the catalogue's words. It is left out of a diagnosis, and asked
/// afterwards.
struct NetworkLearnt {
  double rms_dph = 0;  ///< of what it adds, over the rows
  /// Part of that, 0..1 (whitened squares), which the model's own effects could not do themselves.
  double beyond_effects = 0;
  struct Share {
    model::EffectTerm term;  ///< where its shape parameters fit best; no coefficients
    double share = 0;  ///< of what is beyond the effects, 0..1; shares of different effects overlap
  };
  std::vector<Share> effects;  ///< each by itself, the largest first
};

/// Evaluates `network` over the rows of `series`, whose recordings have what its inputs need, and
/// takes out what `project_out_model` takes out of any regressor. An event is no answer.
NetworkLearnt ask_network(const model::RealNetwork& network, const series::SignalSeries& series,
                          const std::vector<Candidate>& candidates,
                          const ProjectOutModel& project_out_model);

}  // namespace fogcomp::diagnosis
