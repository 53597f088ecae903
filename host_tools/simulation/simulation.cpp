#include "simulation/simulation.hpp"

#include <algorithm>
#include <cmath>

#include "recording/columns.hpp"

namespace fogcomp::simulation {
namespace {

constexpr std::size_t kChunkRows = 8192;

// Channels before the extension inputs and the effects, in the order of channel_values().
enum Channel : std::size_t { kPowered, kRate, kInputRate, kSensor, kCoil, kAir, kFirstInput };
constexpr std::size_t kFirstEffect = kFirstInput + fog::kExtensionInputs;
constexpr std::size_t kSensor2 = kFirstInput + extension_number(fog::Input::temperature2);

std::vector<RowMeans::Between> channel_kinds(std::size_t effects) {
  std::vector<RowMeans::Between> kinds(kFirstEffect + effects, RowMeans::Between::straight);
  for (const std::size_t held : {std::size_t{kPowered}, std::size_t{kSensor}, kSensor2}) {
    kinds[held] = RowMeans::Between::held;
  }
  return kinds;
}

void append(std::vector<double>& all, const std::vector<double>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

Simulation::Simulation(const GyroDescription& gyro, const Programme& programme,
                       const SimulationOptions& options)
    : period_s_(1 / options.rate_hz),
      total_rows_(
          static_cast<std::size_t>(std::floor(programme.duration_s() * options.rate_hz + 1e-6))),
      scales_(peak_scales(gyro, programme, options.earth, options.grid, options.seed)),
      model_(gyro, programme, options.earth, options.grid, options.seed, scales_),
      noises_(make_noise(gyro.part("noise"), period_s_, options.seed)),
      quantizer_(gyro.part("noise")["quantization"], period_s_),
      means_(options.grid.step_s, period_s_, channel_kinds(gyro.effects().size()),
             channel_values()),
      switches_power_(programme.switches_power) {
  for (const auto& effect : gyro.effects()) effect_names_.push_back(effect.description->name);
  for (const NamedNoise& noise : noises_) noise_names_.push_back(noise.name);
}

std::vector<double> Simulation::channel_values() const {
  const GyroState& state = model_.state();
  std::vector<double> values(kFirstEffect);
  values[kPowered] = state.powered ? 1 : 0;
  values[kRate] = model_.rate_dph();
  values[kInputRate] = state.input_rate_dph;
  values[kSensor] = model_.sensor_degc();
  values[kCoil] = state.thermal->coil_mean_degc();
  values[kAir] = state.chamber->air_degc;
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
    values[kFirstInput + i] = state.ambient[fog::extension_input(i)];
  }
  const std::vector<double>& effects = model_.contributions_dph();
  values.insert(values.end(), effects.begin(), effects.end());
  return values;
}

// The true means of the present row.
void Simulation::keep(const std::vector<double>& means, RowChunk& chunk) const {
  chunk.time_s.push_back(static_cast<double>(row_) * period_s_);
  chunk.temperature_degc.push_back(means[kSensor]);
  chunk.rate_dph.push_back(means[kRate]);
  chunk.input_rate_dph.push_back(means[kInputRate]);
  if (switches_power_) {
    chunk.uptime_s.push_back(static_cast<double>(row_ - power_on_row_) * period_s_);
  }
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
    chunk.extension[i].push_back(means[kFirstInput + i]);
  }
  chunk.coil_degc.push_back(means[kCoil]);
  chunk.chamber_degc.push_back(means[kAir]);
  for (std::size_t e = 0; e < effect_names_.size(); ++e) {
    chunk.effects_dph[e].push_back(means[kFirstEffect + e]);
  }
}

bool Simulation::next(RowChunk& chunk) {
  const std::size_t rows = std::min(kChunkRows, total_rows_ - row_);
  if (rows == 0) return false;

  // Noise is drawn for every row, recorded or not: a row's noise depends on its time alone.
  std::vector<std::vector<double>> noises(noises_.size(), std::vector<double>(rows));
  std::vector<double> noise_sum(rows, 0);
  for (std::size_t n = 0; n < noises_.size(); ++n) {
    noises_[n].source->fill(noises[n].data(), rows);
    for (std::size_t row = 0; row < rows; ++row) noise_sum[row] += noises[n][row];
  }

  chunk = RowChunk{};
  chunk.effects_dph.resize(effect_names_.size());
  chunk.noises_dph.resize(noises_.size());
  std::vector<double> means(kFirstEffect + effect_names_.size());
  for (std::size_t row = 0; row < rows; ++row, ++row_) {
    while (means_.needs_step()) {
      model_.step();
      means_.push(channel_values());
    }
    means_.next_row(means.data());
    if (means[kPowered] < 1 - 1e-6) {
      power_on_row_ = row_ + 1;
      continue;
    }
    keep(means, chunk);
    chunk.rate_dph.back() += noise_sum[row];
    for (std::size_t n = 0; n < noises.size(); ++n) chunk.noises_dph[n].push_back(noises[n][row]);
  }
  quantizer_.apply(chunk.rate_dph.data(), chunk.rows());
  return true;
}

SimulatedRecording record(Simulation& simulation, double period_s) {
  SimulatedRecording result;
  result.effects_dph.resize(simulation.effect_names().size());
  recording::Recording& recording = result.recording;
  recording.period_s = period_s;
  recording.stretch_starts = {0};
  for (RowChunk chunk; simulation.next(chunk);) {
    for (const recording::ColumnInfo& info : recording::kColumns)
      append(recording[info.column], chunk[info.column]);
    for (std::size_t i = 0; i < result.effects_dph.size(); ++i) {
      append(result.effects_dph[i], chunk.effects_dph[i]);
    }
  }
  return result;
}

}  // namespace fogcomp::simulation
