#pragma once

#include <Eigen/Core>
#include <vector>

#include "judge/rivals.hpp"

namespace fogcomp::judge {

/// Levels of a gyro's noise relative to the white noise of a row, and how probable beforehand.
struct NoiseRatios {
  double flicker = 0;      ///< variance of a mode at an angle of one per row
  double walk = 0;         ///< the same
  double turn_on = 0;      ///< variance of the power-ons' biases
  double temperature = 1;  ///< what the temperature's errors make of the drift, of what is expected
  double log_prior = 0;
};

/// All noises that are tried: each level from one that the slowest mode hardly shows to one that
/// hides everything. A noise that is known is tried without and with its random walks.
std::vector<NoiseRatios> possible_noises(const Rivals& rivals);

/// What one noise makes of the rivals: inner products weighted by it, without the model.
struct AtNoise {
  AtNoise() = default;
  AtNoise(const Rivals& rivals, const NoiseRatios& ratios);

  NoiseRatios ratios;
  Eigen::VectorXd weights;            ///< of each band
  double log_density = 0;             ///< of the determinants, and of the noise beforehand
  double left = 0;                    ///< square of the drift that the model leaves
  Eigen::VectorXd smooth;             ///< squares of something else's directions, at right angles
  Eigen::VectorXd with_smooth;        ///< products of these with the drift
  Eigen::MatrixXd smooth_in_effects;  ///< and with the effects' columns
  Eigen::MatrixXd model_in_effects;   ///< of the model's directions, orthonormal, with these
  Eigen::VectorXd with_drift;         ///< of the effects' columns
  Eigen::MatrixXd own;                ///< of each shape's columns among themselves: Place::within()
};

/// One noise, and smooth functions of one size or none.
struct Setting {
  Setting(const Rivals& rivals, const AtNoise& noise, std::size_t smooth_number,
          double smooth_size);

  const AtNoise* noise = nullptr;
  std::size_t smooth_number = 0;  ///< of the size of the smooth functions; 0: none
  double log_density = 0;         ///< with that of these; a prior of sizes is not in it
  double left = 0;                ///< of the drift
  Eigen::VectorXd shrink;         ///< of something else's directions
  Eigen::VectorXd with_drift;     ///< products of the effects' columns with what is left
  Eigen::MatrixXd own;            ///< of each shape's columns among themselves: Place::within()
  Eigen::VectorXd square;         ///< of each of these columns
};

}  // namespace fogcomp::judge
