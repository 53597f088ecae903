#pragma once

#include <cmath>
#include <random>

#include "model/drift_model.hpp"
#include "series/signal_series.hpp"
#include "support/sample_models.hpp"

namespace fog::test {

/// These effects, no network, the gyro's averaging and calibration as the paper-like model's.
inline fogcomp::model::Model model_of(const std::vector<fogcomp::model::EffectTerm>& terms) {
  fogcomp::model::Model model = paper_like_model();
  model.network = {};
  model.terms = terms;
  return model;
}

/// The effects of the paper-like model, without its network.
inline fogcomp::model::Model truth() {
  return model_of(paper_like_model().terms);
}

/// Noise of a recording's rows: white and one slow Gauss-Markov component.
struct RowNoise {
  double white_dph = 0;
  double slow_dph = 0;
  double slow_tau_s = 300;
};
constexpr RowNoise kQuietNoise{0.024, 0.004, 600};

/// A recording of 10 s rows: soaks and ramps between -40 and 60 degC (ten hours), whose drift is
/// exactly that of `truth`, plus noise.
inline fogcomp::recording::Recording recording_of(const fogcomp::model::Model& truth,
                                                  const RowNoise& noise, std::uint64_t seed) {
  constexpr double kRow = 10;
  std::vector<double> temperature{20};
  const auto soak = [&](int rows) {
    for (int i = 0; i < rows; ++i) temperature.push_back(temperature.back());
  };
  const auto ramp_to = [&](double target, double degc_per_min) {
    const double step = degc_per_min * kRow / 60;
    while (std::abs(temperature.back() - target) > step) {
      temperature.push_back(temperature.back() + std::copysign(step, target - temperature.back()));
    }
    temperature.push_back(target);
  };
  soak(360);
  ramp_to(-40, 0.7);
  soak(360);
  ramp_to(60, 0.9);
  soak(360);
  ramp_to(20, 0.5);
  soak(360);

  fogcomp::recording::Recording recording;
  recording.file = "simulated";
  recording.period_s = kRow;
  recording.stretch_starts = {0};
  fogcomp::model::RealDriftModel drift(truth, kRow);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const double decay = std::exp(-kRow / noise.slow_tau_s);
  double slow = noise.slow_dph * normal(random);
  // The board's order: a row's own means count from the next row on.
  const auto means = [&](std::size_t row, double blocks_since_power_on) {
    fogcomp::model::RealBlock block;
    block.temperature = temperature[row];
    block.elapsed = blocks_since_power_on;
    return block;
  };
  drift.start(means(0, 0));
  for (std::size_t i = 0; i < temperature.size(); ++i) {
    recording.time_s.push_back(kRow * static_cast<double>(i));
    recording.temperature_degc.push_back(temperature[i]);
    recording.rate_dph.push_back(drift.drift_dph() + slow + noise.white_dph * normal(random));
    slow = decay * slow + noise.slow_dph * std::sqrt(1 - decay * decay) * normal(random);
    drift.step(means(i, static_cast<double>(i) + 1));
  }
  return recording;
}

/// Noise alone, at one temperature but for so much `within` of what recording_of() has.
inline fogcomp::recording::Recording static_recording(double soak_degc, double within,
                                                      const RowNoise& noise, std::uint64_t seed) {
  fogcomp::recording::Recording recording = recording_of(model_of({}), noise, seed);
  for (double& degc : recording.temperature_degc) degc = soak_degc + within * (degc - 20);
  return recording;
}

/// Every `step`-th row: a recording as long, in longer rows, for less work.
inline fogcomp::recording::Recording thinned(fogcomp::recording::Recording recording,
                                             std::size_t step) {
  for (auto* column : {&recording.time_s, &recording.temperature_degc, &recording.rate_dph}) {
    std::size_t kept = 0;
    for (std::size_t row = 0; row < column->size(); row += step) (*column)[kept++] = (*column)[row];
    column->resize(kept);
  }
  recording.period_s *= static_cast<double>(step);
  return recording;
}

}  // namespace fog::test
