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

/// ARMA(2,1) by Hannan and Rissanen's two regressions (Biometrika 69, 1982), on `values` less their
/// running mean over 61. A model that is not stationary, or fewer than 200 values: white noise.
ArmaNoise fit_arma(fog::Span<const double> values);

/// What a Kalman filter and smoother make of a signal that is a straight line with a slowly
/// changing slope plus ARMA noise; the slope's wander is the one of a grid that makes the values
/// likeliest. In place; returns the noise.
ArmaNoise kalman_smooth(fog::Span<double> values);

}  // namespace fogcomp::denoise
