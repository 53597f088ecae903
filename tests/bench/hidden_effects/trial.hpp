#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "case_plan.hpp"
#include "recording/recording.hpp"

namespace fogcomp::bench {

/// A recording without noise, in memory, with the contribution of each simulated effect.
struct TrialRun {
  recording::Recording recording;
  std::vector<std::string> effects;
  std::vector<std::vector<double>> contributions_dph;  ///< per effect, per row
};

/// Simulates a run of the plan with the hidden effects at natural size; a hidden bias_temperature
/// without its lower orders.
TrialRun simulate_trial(const CasePlan& plan, const PlannedRun& run);

}  // namespace fogcomp::bench
