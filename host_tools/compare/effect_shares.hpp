#pragma once

#include <string>
#include <vector>

namespace fogcomp::compare {

/// What one part of a model (an effect, or the network) does on a run.
struct EffectShare {
  std::string name;
  double mean_dph = 0;  ///< of its contribution
  double std_dph = 0;   ///< of its contribution, about that mean
  /// Rise of the residual's sum of squares where this part alone is left out and all others stay as
  /// fitted, in units of the raw data's; both about their means, as a constant is no drift. Parts
  /// that go together in a run share what they explain, so the shares need not add up to 1; one
  /// below 0: the run is fitted better without this part.
  double share = 0;
};

/// A value per row each; `part_dph`: the contribution of one part.
EffectShare share_of(const std::string& name, const std::vector<double>& part_dph,
                     const std::vector<double>& residual_dph,
                     const std::vector<double>& measured_dph);

}  // namespace fogcomp::compare
