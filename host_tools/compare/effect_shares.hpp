#pragma once

#include <string>
#include <vector>

namespace fogcomp::compare {

/// Contribution of one part of a model (an effect, or the network) on a run.
struct EffectShare {
  std::string name;
  double mean_dph = 0;  ///< of its contribution
  double std_dph = 0;   ///< of its contribution, about that mean
  /// Increase of the residual's sum of squares without this part, with all others as fitted,
  /// relative to that of the raw data; both about their means, because a constant is no drift.
  /// Parts that are correlated in a run share their contribution, so the sum need not be 1. Below
  /// 0: the run is described better without this part.
  double share = 0;
};

/// One value per row each; `part_dph`: contribution of one part.
EffectShare share_of(const std::string& name, const std::vector<double>& part_dph,
                     const std::vector<double>& residual_dph,
                     const std::vector<double>& measured_dph);

}  // namespace fogcomp::compare
