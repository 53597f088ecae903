#pragma once

#include <functional>
#include <vector>

#include "research/study.hpp"

namespace fogcomp::research {

/// Studies gyros `settings.seed`, seed + 1 ... in parallel on the processor's cores; results do not
/// depend on their number. `progress` is called with the fraction done, by one thread at a time; an
/// exception from it ends the study. May be empty.
std::vector<Study> study_gyros(const StudySettings& settings, std::size_t gyros,
                               const std::function<void(double)>& progress);

/// Medians over the gyros for one model.
struct ModelMedians {
  std::string name;
  double std_dph = 0;                      ///< of the residual on its own run
  double drift_dph = 0;                    ///< the same without the noise floor
  double truth_rms_dph = 0;                ///< error against the noise-free truth
  double cut = 0;                          ///< 1 - std / raw std
  double cut_of_bound = 0;                 ///< cut / (1 - floor / raw std)
  std::vector<double> held_out_drift_dph;  ///< per held-out profile
  std::vector<double> held_out_truth_rms_dph;
};
std::vector<ModelMedians> medians_of(const std::vector<Study>& studies);

/// Medians over the gyros of the error due to noise alone (research/estimate_floor.hpp).
struct FloorMedians {
  double own_dph = 0;
  std::vector<double> held_out_dph;  ///< per held-out profile
};
FloorMedians floors_of(const std::vector<Study>& studies);

}  // namespace fogcomp::research
