#pragma once

#include <vector>

#include "series/signal_series.hpp"
#include "support/typical_effects.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fog::test {

inline constexpr const char* kBasic = "bias,bias_temperature:order=2,temperature_rate";

/// The effects of kBasic.
inline std::vector<fogcomp::model::EffectTerm> basic() {
  return {natural_term("bias", {}, {0.7}), natural_term("bias_temperature", {2}, {-4e-4, -3e-5}),
          natural_term("temperature_rate", {}, {0.12})};
}

/// Drift of the coil without the board's delays, and noise.
inline fogcomp::recording::Recording recording_with(
    const std::vector<fogcomp::model::EffectTerm>& hidden, std::uint64_t seed,
    const RowNoise& noise = kQuietNoise) {
  std::vector<fogcomp::model::EffectTerm> terms = basic();
  terms.insert(terms.end(), hidden.begin(), hidden.end());
  const Model model = model_of(terms);
  fogcomp::recording::Recording recording = recording_of(model_of({}), noise, seed);
  fogcomp::series::SignalSeries series(model, fogcomp::series::Phase::zero);
  series.add(fogcomp::series::make_blocks(recording));
  for (const fogcomp::model::EffectTerm& term : terms) {
    const Eigen::MatrixXd regressors = series.regressors(term);
    for (std::size_t row = 0; row < recording.rows(); ++row) {
      for (std::size_t i = 0; i < term.coefficients_dph.size(); ++i) {
        recording.rate_dph[row] +=
            term.coefficients_dph[i].value *
            regressors(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(i));
      }
    }
  }
  return recording;
}

}  // namespace fog::test
