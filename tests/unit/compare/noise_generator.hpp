#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/random.hpp"
#include "support/units.hpp"

namespace fogcomp::compare {

/// Coefficients of IEEE Std 952, in its units.
struct NoiseTruth {
  double quantization_deg = 0;
  double angle_random_walk_dprh = 0;
  double bias_instability_dph = 0;
  double rate_random_walk_dphrh = 0;
  double rate_ramp_dphh = 0;
};

/// Samples in deg/h whose Allan deviation is the standard's for `truth`. Written from the
/// definitions of the terms, independent of the code under test. Flicker noise is a sum of
/// first-order processes with corners 2.5 apart from 0.3 of the sample rate down, flat to 3 % in
/// the Allan deviation.
inline std::vector<double> make_noise(const NoiseTruth& truth, std::size_t samples, double period_s,
                                      std::uint64_t seed) {
  constexpr double kCornerRatio = 2.5;
  constexpr std::size_t kCorners = 16;
  Random random(seed, "noise of a known truth");
  const auto normal = [&random] { return random.gaussian(); };
  const double period_h = period_s / 3600;

  const double variance = std::pow(truth.bias_instability_dph, 2) * std::log(kCornerRatio) / kPi;
  std::array<double, kCorners> keep{};
  std::array<double, kCorners> state{};
  for (std::size_t i = 0; i < kCorners; ++i) {
    keep[i] = std::exp(-1.8 * std::pow(kCornerRatio, -static_cast<double>(i)));
    state[i] = std::sqrt(variance) * normal();
  }

  std::vector<double> rate(samples);
  double angle_error = normal();
  double walk = 0;
  for (std::size_t n = 0; n < samples; ++n) {
    const double last_angle_error = angle_error;
    if (truth.quantization_deg > 0) angle_error = normal();
    double flicker = 0;
    if (variance > 0) {
      for (std::size_t i = 0; i < kCorners; ++i) {
        state[i] = keep[i] * state[i] + std::sqrt(variance * (1 - keep[i] * keep[i])) * normal();
        flicker += state[i];
      }
    }
    if (truth.rate_random_walk_dphrh > 0) {
      walk += truth.rate_random_walk_dphrh * std::sqrt(period_h) * normal();
    }
    rate[n] = truth.quantization_deg * (angle_error - last_angle_error) / period_h +
              truth.angle_random_walk_dprh / std::sqrt(period_h) * normal() + flicker + walk +
              truth.rate_ramp_dphh * period_h * static_cast<double>(n);
  }
  return rate;
}

}  // namespace fogcomp::compare
