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

/// A model on one run.
struct Score {
  MeanStd residual;          ///< measured - predicted
  double drift_dph = 0;      ///< sqrt(std^2 - floor^2)
  double truth_rms_dph = 0;  ///< predicted - noise-free truth
};

/// One model, fitted to the paper's run.
struct ModelResult {
  std::string name;
  std::string chosen;       ///< what the fit chose
  Eigen::VectorXd own_dph;  ///< predicted for the rows of the paper's run
  Score own;
  std::vector<Score> held_out;  ///< a score per held-out profile
};

/// One way to denoise, on the rows of the paper's run.
struct DenoiserResult {
  std::string name;
  double truth_rms_dph = 0;  ///< denoised - noise-free truth
};

/// What the study's models are held against that they never saw.
inline const std::vector<std::string> kHeldOutProfiles{"reversed", "random_steps"};

/// The whole pipeline on one simulated gyro.
struct Study {
  SimulatedRun run;              ///< the paper's
  Eigen::VectorXd denoised_dph;  ///< its rows, soft thresholds
  Eigen::VectorXd hard_dph;      ///< the same with hard ones
  std::vector<DenoiserResult> denoisers;
  MeanStd raw;
  std::vector<double> held_out_raw_std_dph;
  std::vector<double> held_out_floor_dph;
  double estimate_floor_dph = 0;  ///< of error, on its own run; see research/estimate_floor.hpp
  std::vector<double> held_out_estimate_floor_dph;
  std::vector<ModelResult> models;

  const ModelResult& model(const std::string& name) const;
  /// What the best model could cut of the whole run's std: 1 - floor / raw std.
  double bound() const { return 1 - run.noise_floor_dph / raw.std_dph; }
  /// Values of the rows of one of the programme's segments; of all rows for "all".
  Eigen::VectorXd of_segment(const std::string& name, const Eigen::VectorXd& values) const;
};

struct StudySettings {
  std::uint64_t seed = 1;
  int epochs = 5000;                ///< of backpropagation
  int iterations = 300;             ///< of swarm and population
  std::vector<std::string> models;  ///< names of comparators()
};

/// What the effects of the study's models are; the simulator's physics, in the catalogue's terms.
extern const char* const kStudyEffects;

/// What all runs of a study have in common. Must outlive it.
const model::Model& study_model();

Study run_study(const StudySettings& settings);

}  // namespace fogcomp::research
