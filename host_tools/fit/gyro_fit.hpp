#pragma once

#include <optional>
#include <vector>

#include "fit/noise_weighted_fit.hpp"
#include "model/model.hpp"
#include "series/signal_series.hpp"
#include "series/term_columns.hpp"

namespace fogcomp::fit {

/// The gyro's own values of a model's terms. A board's derivative has noise, steps and a delay,
/// which its coefficients make up for: a coil's lag of 300 s becomes about 190 s, and a part of
/// K dT/dt goes to the temperature. Here the terms are those of the gyro's own temperature
/// (series/measured_temperature.hpp).
struct GyroFit {
  std::vector<model::GyroValues> terms;
  model::Model::Uncertainty uncertainty;
};

/// Of a fit by Reading::of_gyro: its terms, and columns beside them, of which `offsets` are biases
/// of power-ons. Nothing if the rows do not determine the terms.
std::optional<GyroFit> values_of_gyro(const KnownRegressors& known, const NoiseWeightedFit& fit,
                                      const series::ColumnRange& offsets);

}  // namespace fogcomp::fit
