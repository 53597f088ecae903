#pragma once

#include <vector>

#include "core/signal/span.hpp"

namespace fogcomp::denoise {

/// x[t] = phi1 x[t-1] + phi2 x[t-2] + e[t] + theta e[t-1], e white.
struct ArmaNoise {
  double phi1 = 0;
  double phi2 = 0;
  double theta = 0;
  double variance = 0;  ///< of e
};

/// Fits ARMA(2,1) by the two regressions of Hannan and Rissanen (Biometrika 69, 1982) to `values`
/// less their running mean over 61. White noise if the model is not stationary, or for fewer than
/// 200 values.
ArmaNoise fit_arma(fog::Span<const double> values);

/// Kalman filter and smoother for a straight line with a slowly changing slope plus ARMA noise; the
/// variance of the slope's change is chosen from a grid by maximum likelihood. In place; returns
/// the noise.
ArmaNoise kalman_smooth(fog::Span<double> values);

}  // namespace fogcomp::denoise
