#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "network/trainer.hpp"

namespace fogcomp::network {

/// Training data of a network, row by row, in physical units, from any source.
struct NetworkTask {
  Eigen::MatrixXd inputs;               ///< rows x inputs
  Eigen::VectorXd target_dph;           ///< a value per row
  Eigen::VectorXd weights;              ///< row weights
  std::vector<std::size_t> run_starts;  ///< first row of each recording; starts with 0
  Whiten whiten = nullptr;              ///< for the noise of target_dph; empty: independent rows
};

/// Mapping of the target to the output's +-1.
enum class TargetScaling : std::uint8_t {
  about_zero,  ///< with margin; a network that learns nothing gives 0: for residuals of effects
  min_max,     ///< min and max become -1 and +1, like MATLAB's mapminmax: for a whole drift
};

struct NetworkSettings {
  int hidden = 10;  ///< 1 to kMaxTrainedHidden
  fog::Activation hidden_activation = fog::Activation::logsig;
  fog::Activation output_activation = fog::Activation::tansig;
  TargetScaling scaling = TargetScaling::about_zero;
  std::string trainer = "lm";  ///< one of trainer_names()
  TrainerSettings training;
};

struct TrainedNetwork {
  struct Input {
    double centre = 0;      ///< min-max normalisation: (x - centre) / half_range, clipped to +-1
    double half_range = 1;  ///< > 0
  };
  std::vector<Input> inputs;
  model::RealLayer hidden;
  model::RealLayer output;
  double centre_dph = 0;  ///< drift = centre + amplitude * output
  double amplitude_dph = 0;
  double rms_before_dph = 0;  ///< of the target, over all rows
  double rms_after_dph = 0;   ///< of target - drift, over all rows
  TrainerResult result;

  /// For any rows: rows x inputs -> deg/h.
  Eigen::VectorXd drift_dph(const Eigen::MatrixXd& rows) const;
};

/// Normalises, trains, and stores the scales in the result. With several runs, the last one is held
/// out if its rows count, and training stops at its smallest error. Rows of the same run cannot
/// serve for that, because they share noise and history. Throws InputError if no row counts.
TrainedNetwork train_network(const NetworkTask& task, const NetworkSettings& settings);

}  // namespace fogcomp::network
