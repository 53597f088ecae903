#pragma once

#include <optional>
#include <vector>

#include "recording/segments.hpp"

namespace fogcomp::compare {

/// max |b(T) - b(Tref)| / |T - Tref| over soaks; Tref: the soak nearest to 20 degC. Soaks within
/// 5 degC of it are not used.
struct SoakSlope {
  std::optional<double> bias_dph_per_degc;
  std::optional<double> reference_degc;
};

/// Coefficients of dT/dt > 0 and dT/dt < 0, deg/h per degC/min, fitted together with a parabola in
/// T to all rows; dT/dt over two minutes. Absent if ramps and parabola cannot be separated, as in a
/// single ramp without soaks.
struct RateTerms {
  std::optional<double> heating_dph_per_degc_per_min;
  std::optional<double> cooling_dph_per_degc_per_min;
};

/// Largest distance between heating and cooling branch at equal T (in twentieths of the range), and
/// its temperature. Its noise is that of the mean over a twentieth of a ramp.
struct WidestLoop {
  std::optional<double> hysteresis_dph;
  std::optional<double> hysteresis_at_degc;
};

/// Dependence of the bias on temperature, in the terms of IEEE Std 952 and 528. A value that the
/// recording cannot show is absent.
struct TemperatureSensitivity : SoakSlope, RateTerms, WidestLoop {};

/// `segments` refer to rows (segments_on).
TemperatureSensitivity temperature_sensitivity(const recording::Recording& rows,
                                               const std::vector<recording::Segment>& segments);

}  // namespace fogcomp::compare
