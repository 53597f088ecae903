#pragma once

#include <optional>

#include "diagnosis/diagnosis_data.hpp"
#include "fit/noise_weighted_fit.hpp"

namespace fogcomp::diagnosis {

/// A straight line in the time since power-on, beside the model's effects. No effect of the
/// catalogue is one: a board's time has no bound.
struct LineInTime {
  double slope_dphh = 0;  ///< deg/h per hour
  double sigma_dphh = 0;  ///< one standard deviation

  /// Whether noise alone has such a slope less often than rules::kFaintChance.
  bool is_significant() const;
};

/// The line that fits best beside the effects of `fit`, whose coefficients and shapes are solved
/// for again with it. `fit`: fit_for_diagnosis() of `data`. The standard deviation is that of
/// fit::predict(): it covers flicker and a random walk of the bias. Nothing if the
/// rows do not determine the line, e.g. beside another effect of time.
std::optional<LineInTime> find_line_in_time(const DiagnosisData& data,
                                            const fit::NoiseWeightedFit& fit);

}  // namespace fogcomp::diagnosis
