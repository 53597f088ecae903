#pragma once

#include <utility>
#include <vector>

#include "fit/identify.hpp"
#include "fit/turn_on_repeatability.hpp"
#include "model/effect_list.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fog::test {

/// Static runs in rows of a minute at 20 degC apart, with these biases.
inline std::vector<fogcomp::recording::Recording> runs_apart(const std::vector<double>& biases_dph,
                                                             double dph_per_degc, double within) {
  std::vector<fogcomp::recording::Recording> runs;
  for (std::size_t i = 0; i < biases_dph.size(); ++i) {
    fogcomp::recording::Recording run = thinned(
        static_recording(20.0 * static_cast<double>(i) - 40, within, kQuietNoise, i + 1), 6);
    for (std::size_t row = 0; row < run.rows(); ++row)
      run.rate_dph[row] += biases_dph[i] + dph_per_degc * run.temperature_degc[row];
    runs.push_back(std::move(run));
  }
  return runs;
}

/// Of a slope with temperature, beside a bias.
inline double chance_of_slope(const std::vector<fogcomp::recording::Recording>& runs) {
  std::vector<fogcomp::model::Model> models;
  for (const char* effects : {"bias", "bias,bias_temperature:order=1"}) {
    fogcomp::model::Model model = model_of(fogcomp::model::parse_effects(effects));
    model.average_s = 60;
    models.push_back(std::move(model));
  }
  fogcomp::series::SignalSeries series(models[0]);
  for (const fogcomp::recording::Recording& run : runs)
    series.add(fogcomp::series::make_blocks(run));
  const fogcomp::fit::KnownRegressors known(series);
  fogcomp::fit::identify(models[0], known);
  const fogcomp::fit::Identification fit = fogcomp::fit::identify(models[1], known);
  return fogcomp::fit::chance_of_biases(known, models[0].terms, models[1].terms,
                                        {fit.noise, fit.row_weights, false});
}

}  // namespace fog::test
