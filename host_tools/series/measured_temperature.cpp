#include "series/measured_temperature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "series/block_walk.hpp"
#include "series/temperature_smoother.hpp"
#include "support/units.hpp"

namespace fogcomp::series {
namespace {

// Noise and walk are found to this factor, from at most so many readings.
constexpr double kFactor = 2;
constexpr std::size_t kReadings = 4000;
constexpr double kLeast = 1e-18;       // of the walk: none
constexpr double kFinest_degc = 1e-4;  // of noise: what is finer costs digits
// Noise of a thermometer, in steps: between sharper edges the moments lose their digits, and the
// rate jumps.
constexpr double kSharpest = 0.01;
constexpr double kNotRead = std::numeric_limits<double>::quiet_NaN();

// Readings between restarts; the first block counts as one.
struct Part {
  std::int64_t first_number;
  TemperatureReadings readings;
};

std::vector<Part> parts_of(const BlockSeries& series) {
  std::vector<Part> parts;
  each_part(series, [&](std::size_t first, std::size_t end) {
    Part& part = parts.emplace_back();
    part.first_number = series.blocks[first].number;
    part.readings.interval_s = series.block_s;
    for (std::size_t i = first; i < end; ++i) {
      const BlockSeries::Block& block = series.blocks[i];
      part.readings.degc.resize(static_cast<std::size_t>(block.number - part.first_number),
                                kNotRead);
      const bool is_read = block.has_reading || i == first;
      part.readings.degc.push_back(is_read ? block.means.temperature : kNotRead);
    }
    const std::int64_t last = series.blocks[end - 1].number - part.first_number;
    part.readings.degc.resize(static_cast<std::size_t>(last) + 1, kNotRead);
  });
  return parts;
}

// The most probable noise and walk, each in turn, to kFactor.
TemperatureLaw most_probable(const std::vector<Part>& parts, TemperatureLaw law) {
  std::size_t readings = 0;
  for (const Part& part : parts) {
    const std::vector<double>& degc = part.readings.degc;
    readings += static_cast<std::size_t>(
        std::count_if(degc.begin(), degc.end(), [](double each) { return !std::isnan(each); }));
  }
  const std::size_t every = (readings + kReadings - 1) / kReadings;
  const auto log_likelihood_of = [&](const TemperatureLaw& tried) {
    double sum = 0;
    for (const Part& part : parts) sum += log_likelihood(part.readings, every, tried);
    return sum;
  };
  double best = log_likelihood_of(law);
  const auto improve = [&](double TemperatureLaw::*value, double factor) {
    bool any = false;
    for (;;) {
      TemperatureLaw tried = law;
      tried.*value *= factor;
      if (tried.*value < kLeast || tried.*value > 1 / kLeast) return any;
      if (tried.noise_degc < std::max(kFinest_degc, kSharpest * tried.step_degc)) return any;
      const double probability = log_likelihood_of(tried);
      if (!(probability > best + 1e-6)) return any;
      best = probability;
      law = tried;
      any = true;
    }
  };
  constexpr int kMaxTurns = 10;
  for (int turn = 0; turn < kMaxTurns; ++turn) {
    bool moved = false;
    for (double TemperatureLaw::*value : {&TemperatureLaw::walk, &TemperatureLaw::noise_degc}) {
      moved = improve(value, kFactor * kFactor) || moved;
      moved = improve(value, 1 / (kFactor * kFactor)) || moved;
    }
    if (!moved) break;
  }
  for (double TemperatureLaw::*value : {&TemperatureLaw::walk, &TemperatureLaw::noise_degc}) {
    if (!improve(value, kFactor)) improve(value, 1 / kFactor);
  }
  return law;
}

// Spectral density of the errors as if the temperature's walk were everywhere the same: variances
// of temperature and rate are (r^3 q)^(1/4) / sqrt(8) and (r q^3)^(1/4) / sqrt(8) then.
void set_errors(double var_degc, double var_per_s, Thermometer& thermometer) {
  const double white = std::sqrt(8.0) * var_degc * std::sqrt(var_degc / var_per_s);
  thermometer.white_degc2_s = white;
  thermometer.rate_walk_degc2_per_s3 = white * std::pow(var_per_s / var_degc, 2);
}

}  // namespace

const TemperatureNow& MeasuredTemperature::at(std::int64_t number) const {
  const auto behind = std::upper_bound(
      parts.begin(), parts.end(), number,
      [](std::int64_t value, const Part& part) { return value < part.first_number; });
  const Part& part = behind == parts.begin() ? parts.front() : *(behind - 1);
  const auto last = static_cast<std::int64_t>(part.values.size()) - 1;
  const std::int64_t index = std::clamp<std::int64_t>(number - part.first_number, 0, last);
  return part.values[static_cast<std::size_t>(index)];
}

std::shared_ptr<const MeasuredTemperature> temperature_of(const BlockSeries& series) {
  if (series.temperature) return series.temperature;
  return std::make_shared<const MeasuredTemperature>(measured_temperature(series));
}

BlockSeries with_exact_temperature(BlockSeries series) {
  auto exact = std::make_shared<MeasuredTemperature>();
  each_part(series, [&](std::size_t first, std::size_t end) {
    MeasuredTemperature::Part& part = exact->parts.emplace_back();
    part.first_number = series.blocks[first].number;
    for (std::size_t i = first; i < end; ++i) {
      const BlockSeries::Block& before = series.blocks[std::max(first + 1, i) - 1];
      const BlockSeries::Block& after = series.blocks[std::min(end - 1, i + 1)];
      const auto blocks =
          static_cast<double>(std::max<std::int64_t>(1, after.number - before.number));
      const double change = after.means.temperature - before.means.temperature;
      part.values.resize(static_cast<std::size_t>(series.blocks[i].number - part.first_number),
                         part.values.empty() ? TemperatureNow{} : part.values.back());
      part.values.push_back({series.blocks[i].means.temperature,
                             change / blocks / series.block_s * kSecondsPerMinute});
    }
  });
  series.temperature = std::move(exact);
  return series;
}

MeasuredTemperature measured_temperature(const BlockSeries& series) {
  const std::vector<Part> parts = parts_of(series);
  TemperatureLaw law{series.temperature_step_degc,
                     std::max(0.1 * series.temperature_step_degc, 1e-3), 1e-9};
  law = most_probable(parts, law);
  MeasuredTemperature result;
  double var_degc = 0;
  double var_per_s = 0;
  double count = 0;
  for (const Part& part : parts) {
    MeasuredTemperature::Part& values = result.parts.emplace_back();
    values.first_number = part.first_number;
    values.values.reserve(part.readings.degc.size());
    smooth(part.readings, law, [&](const TemperatureState& state) {
      values.values.push_back({state.mean[0], state.mean[1] * kSecondsPerMinute});
      var_degc += state.covariance(0, 0);
      var_per_s += state.covariance(1, 1);
      ++count;
    });
  }
  result.thermometer.resolution_degc = law.step_degc;
  result.thermometer.noise_degc = law.noise_degc;
  set_errors(var_degc / count, var_per_s / count, result.thermometer);
  return result;
}

}  // namespace fogcomp::series
