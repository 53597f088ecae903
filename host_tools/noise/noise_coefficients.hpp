#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "noise/allan.hpp"

namespace fogcomp::noise {

/// A coefficient of IEEE Std 952 Annex C and the half width of its 95 % confidence interval.
struct NoiseCoefficient {
  double value = 0;
  double half_width_95 = 0;
};

/// Coefficients of
///   sigma^2(tau) = 3 Q^2/tau^2 + N^2/tau + B^2 (2/pi) ln 2 + K^2 tau/3 + R^2 tau^2/2,
/// tau in hours. A coefficient that the data cannot show is absent.
struct NoiseCoefficients {
  std::optional<NoiseCoefficient> quantization_deg;        ///< Q
  std::optional<NoiseCoefficient> angle_random_walk_dprh;  ///< N, deg/sqrt(h)
  std::optional<NoiseCoefficient> bias_instability_dph;    ///< B, height of the flat part / 0.664
  std::optional<NoiseCoefficient> rate_random_walk_dphrh;  ///< K, deg/h/sqrt(h)
  std::optional<NoiseCoefficient> rate_ramp_dphh;          ///< R, deg/h/h
};

/// Fits the coefficients to an Allan deviation in deg/h.
///
/// Fits every combination of terms. A coefficient is reported only if all plausible combinations
/// (likelihood ratio against the best, 95 %) contain it, and its interval covers theirs: of two
/// terms that can replace each other neither is reported.
NoiseCoefficients fit_noise_coefficients(const std::vector<AllanPoint>& allan);

/// Allan deviation, deg/h, of a term alone: `term` of AllanModel, `coefficient` in its unit.
double sigma_of_term(Eigen::Index term, double coefficient, double tau_s);

/// Upper bound of B, deg/h, where no flat part is visible: from the lowest point of an Allan
/// deviation, which is not empty, and two of its standard deviations.
double instability_bound_dph(const std::vector<AllanPoint>& allan);

}  // namespace fogcomp::noise
