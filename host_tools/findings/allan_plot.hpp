#pragma once

#include <string>
#include <vector>

#include "findings/plot.hpp"
#include "noise/allan.hpp"
#include "noise/noise_coefficients.hpp"

namespace fogcomp::findings {

/// An Allan deviation in deg/h, with its colour in the other plots.
struct AllanCurve {
  Text label;
  std::string colour;
  const std::vector<noise::AllanPoint>& points;
};

/// Allan deviations with their standard deviations; for the last one also the fitted slopes of IEEE
/// Std 952 that the data show, and their sum.
Plot allan_plot(const std::vector<AllanCurve>& curves, const noise::NoiseCoefficients& fitted);

}  // namespace fogcomp::findings
