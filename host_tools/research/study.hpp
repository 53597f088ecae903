#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "research/simulated_run.hpp"

namespace fogcomp::research {

/// Mean and standard deviation of rows.
struct MeanStd {
  double mean_dph = 0;
  double std_dph = 0;
};
MeanStd mean_and_std(const Eigen::VectorXd& values);

/// Result of a model on one run.
struct Score {
  MeanStd residual;          ///< measured - predicted
  double drift_dph = 0;      ///< sqrt(std^2 - floor^2)
  double truth_rms_dph = 0;  ///< predicted - noise-free truth
};

/// A model fitted to the paper's run.
struct ModelResult {
  std::string name;
  std::string chosen;       ///< choices made by the fit
  Eigen::VectorXd own_dph;  ///< predictions for the rows of the paper's run
  Score own;
  std::vector<Score> held_out;  ///< one per held-out profile
};

/// Result of a denoiser on the rows of the paper's run.
struct DenoiserResult {
  std::string name;
  double truth_rms_dph = 0;  ///< denoised - noise-free truth
};

/// Profiles on which the study's models are judged without training.
inline const std::vector<std::string> kHeldOutProfiles{"reversed", "random_steps"};

/// All results for one simulated gyro.
struct Study {
  SimulatedRun run;              ///< the paper's
  Eigen::VectorXd denoised_dph;  ///< its rows, soft thresholds
  Eigen::VectorXd hard_dph;      ///< the same with hard ones
  std::vector<DenoiserResult> denoisers;
  MeanStd raw;
  std::vector<double> held_out_raw_std_dph;
  std::vector<double> held_out_floor_dph;
  double estimate_floor_dph = 0;  ///< of the error on its own run; see simulated_run.hpp
  std::vector<double> held_out_estimate_floor_dph;
  std::vector<ModelResult> models;

  const ModelResult& model(const std::string& name) const;
  /// Largest possible reduction of the whole run's std: 1 - floor / raw std.
  double bound() const { return 1 - run.noise_floor_dph / raw.std_dph; }
  /// Values of the rows of one segment of the programme; of all rows for "all".
  Eigen::VectorXd of_segment(const std::string& name, const Eigen::VectorXd& values) const;
};

struct StudySettings {
  std::uint64_t seed = 1;
  int epochs = 5000;                ///< of backpropagation
  int iterations = 300;             ///< of swarm and population
  std::vector<std::string> models;  ///< names of comparators()
};

/// Effects of the study's models: the simulator's physics in terms of the catalogue.
extern const char* const kStudyEffects;

Study run_study(const StudySettings& settings);

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

/// Medians over the gyros of the error due to noise alone (simulated_run.hpp).
struct FloorMedians {
  double own_dph = 0;
  std::vector<double> held_out_dph;  ///< per held-out profile
};
FloorMedians floors_of(const std::vector<Study>& studies);

}  // namespace fogcomp::research
