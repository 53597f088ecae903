#pragma once

#include <Eigen/Core>
#include <cstddef>

/// Every number by which offline denoising decides: its unit, where it comes from, and what looks
/// at the decision. The rules for thresholds are MATLAB's and stand with their formulas
/// (thresholds.cpp).
namespace fogcomp::denoise::rules {

/// Standard deviations of a difference of neighbours beyond which a single value that stands out of
/// both is an outlier: 1 of 1.7 million of noise alone. tests/integration/denoise_worth.sh.
constexpr double kDenoiseOutlierSigmas = 5;

// ---- Kalman filter with an ARMA(2, 1) noise, one of the alternatives --------------------------
/// Values of the running mean that takes the drift off before the noise is identified: ten minutes
/// of rows of 10 s. Chosen. tests/unit/denoise/alternatives_test.
constexpr Eigen::Index kRunningMean = 61;
/// Order of the long regression that estimates the innovations first (Hannan & Rissanen): several
/// times that of the model. tests/unit/denoise/alternatives_test.
constexpr Eigen::Index kLongOrder = 12;
/// Values that are enough to identify it: some ten for each unknown of the long regression.
/// tests/unit/denoise/alternatives_test.
constexpr std::size_t kMinValues = 200;

}  // namespace fogcomp::denoise::rules
