#pragma once

#include <cmath>

#include "fit/fit_model.hpp"
#include "model/effect_list.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fog::test {

// Slow noise with a correlation time of half an hour is the noise that a network most easily learns
// as drift.
constexpr RowNoise kSlowNoise{0.024, 0.006, 2000};

struct FittedNetwork {
  fogcomp::model::Model model;
  fogcomp::fit::FitResult result;
  Eigen::VectorXd left_dph;     // by the effects, of the drift without noise; per row
  Eigen::VectorXd network_dph;  // per row; 0 without one
};

// `gyro` fitted with the effects of truth() and 6 neurons.
inline FittedNetwork fit_network(const fogcomp::model::Model& gyro, const RowNoise& noise,
                                 std::uint64_t seed, bool force) {
  FittedNetwork fitted;
  fogcomp::model::Model& model = fitted.model;
  model = model_of(fogcomp::model::parse_effects("bias,bias_temperature:order=3,temperature_rate"));
  fogcomp::series::SignalSeries series(model);
  series.add(fogcomp::series::make_blocks(recording_of(gyro, noise, seed)));
  fogcomp::fit::FitSettings settings;
  settings.network.hidden = 6;
  settings.force_network = force;
  fitted.result = fogcomp::fit::fit_model(model, series, settings);

  fogcomp::series::SignalSeries noise_free(model);
  noise_free.add(fogcomp::series::make_blocks(recording_of(gyro, {}, seed)));
  fitted.left_dph = noise_free.rows().drift_dph - series.drift_dph(model.terms);
  fitted.network_dph.setZero(series.rows().size());
  if (!model.network.present()) return fitted;
  const Eigen::MatrixXd inputs = series.network_inputs(model.network.inputs);
  for (Eigen::Index row = 0; row < inputs.rows(); ++row) {
    fitted.network_dph[row] = model.network.drift_dph(inputs.row(row));
  }
  return fitted;
}

inline double mean_square(const Eigen::VectorXd& values) {
  return values.squaredNorm() / static_cast<double>(values.size());
}

}  // namespace fog::test
