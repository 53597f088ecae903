#pragma once

#include <optional>
#include <vector>

#include "recording/segments.hpp"

namespace fogcomp::compare {

/// How the bias follows temperature, in the terms of IEEE Std 952 and 528. A figure that the
/// recording cannot show is absent.
struct TemperatureSensitivity {
  /// max |b(T) - b(Tref)| / |T - Tref| over soaks; Tref is the soak nearest to 20 degC, and soaks
  /// within 5 degC of it do not count.
  std::optional<double> bias_dph_per_degc;
  std::optional<double> reference_degc;
  /// Coefficients of dT/dt > 0 and dT/dt < 0, deg/h per degC/min, fitted together with a parabola
  /// in T to all rows; dT/dt is taken over two minutes. Absent where ramps and parabola cannot be
  /// told apart, as in a single ramp without soaks.
  std::optional<double> heating_dph_per_degc_per_min;
  std::optional<double> cooling_dph_per_degc_per_min;
  /// Widest distance between heating and cooling branch at equal T (twentieths of the range), and
  /// where it is. Its noise is that of the mean over a twentieth of a ramp.
  std::optional<double> hysteresis_dph;
  std::optional<double> hysteresis_at_degc;
};

/// `segments` count rows (segments_on).
TemperatureSensitivity temperature_sensitivity(const recording::Recording& rows,
                                               const std::vector<recording::Segment>& segments);

}  // namespace fogcomp::compare
