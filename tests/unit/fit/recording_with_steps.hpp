#pragma once

#include <cmath>
#include <random>

#include "fit/identify.hpp"
#include "model/effect_list.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fog::test {

constexpr double kWhiteDph = 0.024;

// White noise, and flicker noise as components an octave and a half apart.
inline fogcomp::recording::Recording noisy_recording(std::uint64_t seed) {
  fogcomp::recording::Recording recording = recording_of(truth(), {kWhiteDph, 0, 300}, seed);
  std::mt19937_64 random(seed + 1000);
  std::normal_distribution<double> normal;
  for (double tau_s = 30; tau_s < 20000; tau_s *= 3) {
    const double decay = std::exp(-10 / tau_s);
    double slow = 0.003 * normal(random);
    for (double& rate : recording.rate_dph) {
      rate += slow;
      slow = decay * slow + 0.003 * std::sqrt(1 - decay * decay) * normal(random);
    }
  }
  return recording;
}

inline void add_step(fogcomp::recording::Recording& recording, double at_s, double size_dph) {
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    if (recording.time_s[i] >= at_s) recording.rate_dph[i] += size_dph;
  }
}

struct FittedWithCuts {
  fogcomp::model::Model model;
  fogcomp::fit::Identification identified;
};

/// Cuts of the first recording.
inline FittedWithCuts fit_with_cuts(const std::vector<fogcomp::recording::Recording>& recordings,
                                    const std::vector<double>& cuts_s) {
  FittedWithCuts result{truth(), {}};
  result.model.terms =
      fogcomp::model::parse_effects("bias,bias_temperature:order=3,temperature_rate");
  fogcomp::series::SignalSeries series(result.model);
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    fogcomp::series::BlockSeries blocks = fogcomp::series::make_blocks(recordings[i]);
    for (const double at_s : cuts_s) {
      if (i == 0) fogcomp::series::set_cut(blocks, at_s, true);
    }
    series.add(blocks);
  }
  result.identified = fogcomp::fit::identify(result.model, series);
  return result;
}

}  // namespace fog::test
