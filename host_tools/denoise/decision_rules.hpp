#pragma once

#include <Eigen/Core>
#include <cstddef>

/// All thresholds of offline denoising: unit, origin, and the test that examines the decision. The
/// threshold rules are MATLAB's and are defined with their formulas (thresholds.cpp).
namespace fogcomp::denoise::rules {

// ---- Kalman filter with an ARMA(2, 1) noise, one of the alternatives --------------------------
/// Values of the running mean that removes the drift before the noise is identified: ten minutes in
/// rows of 10 s. Chosen. tests/unit/denoise/alternatives_test.
constexpr Eigen::Index kRunningMean = 61;
/// Order of the long regression that first estimates the innovations (Hannan & Rissanen): several
/// times that of the model. tests/unit/denoise/alternatives_test.
constexpr Eigen::Index kLongOrder = 12;
/// Smallest number of values to identify it: about ten per unknown of the long regression.
/// tests/unit/denoise/alternatives_test.
constexpr std::size_t kMinValues = 200;

}  // namespace fogcomp::denoise::rules
