#include "research/simulated_run.hpp"

#include <cmath>
#include <utility>

#include "fit/noise_weighted_fit.hpp"
#include "noise/noise_floor.hpp"
#include "noise/whitening.hpp"
#include "recording/recording.hpp"
#include "simulation/embedded_files.hpp"
#include "simulation/programme.hpp"
#include "simulation/simulation.hpp"
#include "support/input_error.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::research {
namespace {

using namespace simulation;

constexpr double kSampleRateHz = 1;

SimulatedRecording simulate(const GyroDescription& gyro, const Programme& programme,
                            std::uint64_t seed) {
  SimulationOptions options;
  options.rate_hz = kSampleRateHz;
  options.seed = seed;
  Simulation run(gyro, programme, options);
  SimulatedRecording samples = record(run, 1 / kSampleRateHz);
  // Further inputs were not recorded.
  recording::Recording plain;
  plain.period_s = samples.recording.period_s;
  plain.stretch_starts = samples.recording.stretch_starts;
  plain.time_s = std::move(samples.recording.time_s);
  plain.temperature_degc = std::move(samples.recording.temperature_degc);
  plain.rate_dph = std::move(samples.recording.rate_dph);
  samples.recording = std::move(plain);
  return samples;
}

Eigen::VectorXd row_means(const std::vector<double>& samples, std::size_t per_row,
                          Eigen::Index rows) {
  const Eigen::Map<const Eigen::VectorXd> all(samples.data(),
                                              static_cast<Eigen::Index>(samples.size()));
  const auto full = static_cast<Eigen::Index>(per_row);
  Eigen::VectorXd means(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    means[i] = all.segment(i * full, std::min(full, all.size() - i * full)).mean();
  }
  return means;
}

std::vector<std::string> segments_of(const Programme& programme, const series::Rows& rows) {
  std::vector<std::string> names;
  auto leg = programme.legs.begin();
  for (const double time_s : rows.time_s) {
    while (leg + 1 != programme.legs.end() && time_s >= leg->end_s) ++leg;
    names.push_back(leg->segment);
  }
  return names;
}

}  // namespace

SimulatedRun simulate_run(const std::string& profile, std::uint64_t seed,
                          const model::Model& settings) {
  GyroDescription gyro;
  gyro.apply_preset(find_text("paper", ready_made_presets(), "preset"), "paper");
  const Programme programme =
      parse_profile(find_text(profile, ready_made_profiles(), "profile"), profile, seed);
  SimulatedRecording samples = simulate(gyro, programme, seed);
  samples.recording.file = profile;

  SimulatedRun run{series::SignalSeries(settings), {}, {}, 0, {}};
  run.series.add(series::make_blocks(samples.recording));
  const series::Rows& rows = run.series.rows();
  run.noise_floor_dph = noise::noise_floor_dph(samples.recording, settings.average_s).value_or(0);
  run.segments = segments_of(programme, rows);
  const auto per_row = static_cast<std::size_t>(std::lround(settings.average_s * kSampleRateHz));
  run.effects_dph.resize(rows.size(), static_cast<Eigen::Index>(samples.effects_dph.size()));
  for (std::size_t i = 0; i < samples.effects_dph.size(); ++i) {
    run.effects_dph.col(static_cast<Eigen::Index>(i)) =
        row_means(samples.effects_dph[i], per_row, rows.size());
  }
  run.truth_dph = run.effects_dph.rowwise().sum();
  return run;
}

double estimate_floor_dph(const SimulatedRun& fitted, const SimulatedRun& asked) {
  const series::Rows& rows = fitted.series.rows();
  const noise::NoiseModel noise = noise::fit_noise(
      noise::noise_samples({rows.drift_dph - fitted.truth_dph}), rows.row_s, rows.longest_run_s());
  const noise::Whitening whitening(noise, rows, rows.weights);
  const LinearFit sizes =
      solve_linear(whitening.apply(fitted.effects_dph), whitening.apply(rows.drift_dph));
  const Eigen::MatrixXd& effects = asked.effects_dph;
  return std::sqrt((effects * sizes.covariance).cwiseProduct(effects).rowwise().sum().mean());
}

}  // namespace fogcomp::research
