#include "series/measured_temperature.hpp"

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "series/block_walk.hpp"
#include "support/units.hpp"

namespace fogcomp::series {
namespace {

// Noise and walk are found to this factor, from at most so many readings.
constexpr double kFactor = 2;
constexpr std::size_t kReadings = 4000;
constexpr double kLeast = 1e-18;  // of noise (degC) and walk: none
// Noise of a thermometer, in steps: between sharper edges the moments lose their digits, and the
// rate jumps.
constexpr double kSharpest = 0.01;

// What a thermometer may be like.
struct Law {
  double step_degc = 0;
  double noise_degc = 0;
  double walk = 0;  // of the rate's slope, degC^2 / s^5
};

// Temperature, its rate (degC/s) and the rate's slope (degC/s^2): between air and thermometer there
// is a heat capacity at least, so that the rate itself has no jumps.
struct State {
  Eigen::Vector3d mean;
  Eigen::Matrix3d covariance;
};

Eigen::Matrix3d transition(double dt) {
  Eigen::Matrix3d f;
  f << 1, dt, dt * dt / 2, 0, 1, dt, 0, 0, 1;
  return f;
}

State predicted(const State& now, double dt, double walk) {
  const Eigen::Matrix3d f = transition(dt);
  const double d2 = dt * dt;
  Eigen::Matrix3d added;
  added << d2 * d2 / 20, d2 * dt / 8, d2 / 6, d2 * dt / 8, d2 / 3, dt / 2, d2 / 6, dt / 2, 1;
  return {f * now.mean, f * now.covariance * f.transpose() + walk * dt * added};
}

// Mean, variance and ln of the probability of a standard normal variable between two limits.
struct Truncated {
  double mean = 0;
  double variance = 0;
  double log_probability = 0;
};

double density(double x) {
  return std::exp(-x * x / 2) / std::sqrt(2 * kPi);
}

Truncated truncated(double low, double high) {
  constexpr double kFar = 6;  // beyond it nearly all is at the nearer limit
  if (low > kFar || high < -kFar) {
    const double limit = low > 0 ? low : high;
    const double length = 1 / std::abs(limit);
    const double end = std::min(length, high - low);
    return {limit + std::copysign(end / 2, limit), end * end / 12,
            -limit * limit / 2 - std::log(std::abs(limit) * std::sqrt(2 * kPi))};
  }
  constexpr double kNarrow = 0.05;  // its difference of probabilities would be rounding
  if (high - low < kNarrow) {
    const double mean = (low + high) / 2;
    return {mean, (high - low) * (high - low) / 12, std::log(density(mean) * (high - low))};
  }
  const double root = std::sqrt(0.5);
  const double inside = low > 0 ? (std::erfc(low * root) - std::erfc(high * root)) / 2
                                : (std::erfc(-high * root) - std::erfc(-low * root)) / 2;
  const double probability = std::max(inside, 1e-300);
  const double mean = (density(low) - density(high)) / probability;
  const double square = 1 + (low * density(low) - high * density(high)) / probability;
  return {mean, std::clamp(square - mean * mean, 0.0, 1.0), std::log(probability)};
}

// Takes a reading; returns the ln of its probability (of its density without steps).
double see(double reading_degc, const Law& law, State& state) {
  const double variance = state.covariance(0, 0) + law.noise_degc * law.noise_degc;
  const double sigma = std::sqrt(variance);
  const double from_reading = (reading_degc - state.mean[0]) / sigma;
  Truncated inside{from_reading, 0, -from_reading * from_reading / 2 - std::log(sigma)};
  if (law.step_degc > 0) {
    const double half = law.step_degc / 2 / sigma;
    inside = truncated(from_reading - half, from_reading + half);
  }
  const Eigen::Vector3d gain = state.covariance.col(0) / sigma;
  state.mean += inside.mean * gain;
  state.covariance -= (1 - inside.variance) * gain * gain.transpose();
  return inside.log_probability;
}

// Nothing is known of the temperature rate but what a chamber can do.
State at_first(double reading_degc, const Law& law) {
  constexpr double kMaxPerMin = 5;
  constexpr double kFastest_s = 10;
  const double degc = std::max(law.step_degc, law.noise_degc);
  const double per_s = kMaxPerMin / kSecondsPerMinute;
  const Eigen::Vector3d sigma(degc, per_s, per_s / kFastest_s);
  return {{reading_degc, 0, 0}, sigma.cwiseAbs2().asDiagonal()};
}

// Readings between restarts.
struct Part {
  std::size_t first;  // block
  std::size_t end;
};

std::vector<Part> parts_of(const BlockSeries& series) {
  std::vector<Part> parts;
  each_part(series, [&](std::size_t first, std::size_t end) { parts.push_back({first, end}); });
  return parts;
}

double log_likelihood(const BlockSeries& series, const std::vector<Part>& parts, std::size_t every,
                      const Law& law) {
  double sum = 0;
  for (const Part& part : parts) {
    State state = at_first(series.blocks[part.first].means.temperature, law);
    std::int64_t number = series.blocks[part.first].number;
    for (std::size_t i = part.first + every; i < part.end; i += every) {
      const BlockSeries::Block& block = series.blocks[i];
      state =
          predicted(state, static_cast<double>(block.number - number) * series.block_s, law.walk);
      number = block.number;
      sum += see(block.means.temperature, law, state);
    }
  }
  return sum;
}

// The most probable noise and walk, each in turn, to kFactor.
Law most_probable(const BlockSeries& series, const std::vector<Part>& parts, Law law) {
  const std::size_t every = (series.blocks.size() + kReadings - 1) / kReadings;
  double best = log_likelihood(series, parts, every, law);
  const auto improve = [&](double Law::*value, double factor) {
    bool any = false;
    for (;;) {
      Law tried = law;
      tried.*value *= factor;
      if (tried.*value < kLeast || tried.*value > 1 / kLeast) return any;
      if (tried.noise_degc < kSharpest * tried.step_degc) return any;
      const double probability = log_likelihood(series, parts, every, tried);
      if (!(probability > best + 1e-6)) return any;
      best = probability;
      law = tried;
      any = true;
    }
  };
  constexpr int kMaxTurns = 10;
  for (int turn = 0; turn < kMaxTurns; ++turn) {
    bool moved = false;
    for (double Law::*value : {&Law::walk, &Law::noise_degc}) {
      moved = improve(value, kFactor * kFactor) || moved;
      moved = improve(value, 1 / (kFactor * kFactor)) || moved;
    }
    if (!moved) break;
  }
  for (double Law::*value : {&Law::walk, &Law::noise_degc}) {
    if (!improve(value, kFactor)) improve(value, 1 / kFactor);
  }
  return law;
}

// Filter forward, smoother backward (Rauch, Tung & Striebel): a state for each block number.
std::vector<State> smoothed(const BlockSeries& series, const Part& part, const Law& law) {
  const std::int64_t first = series.blocks[part.first].number;
  const auto size = static_cast<std::size_t>(series.blocks[part.end - 1].number - first) + 1;
  std::vector<State> states;
  states.reserve(size);
  State state = at_first(series.blocks[part.first].means.temperature, law);
  for (std::size_t i = part.first; i < part.end; ++i) {
    while (states.size() < static_cast<std::size_t>(series.blocks[i].number - first)) {
      states.push_back(state);
      state = predicted(state, series.block_s, law.walk);
    }
    see(series.blocks[i].means.temperature, law, state);
  }
  states.push_back(state);
  const Eigen::Matrix3d f = transition(series.block_s);
  for (std::size_t i = size - 1; i-- > 0;) {
    State& now = states[i];
    const State& later = states[i + 1];
    const State next = predicted(now, series.block_s, law.walk);
    const Eigen::Matrix3d gain = now.covariance * f.transpose() * next.covariance.inverse();
    now.mean += gain * (later.mean - next.mean);
    now.covariance += gain * (later.covariance - next.covariance) * gain.transpose();
  }
  return states;
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

MeasuredTemperature measured_temperature(const BlockSeries& series) {
  const std::vector<Part> parts = parts_of(series);
  Law law{series.temperature_step_degc, std::max(0.1 * series.temperature_step_degc, 1e-3), 1e-9};
  law = most_probable(series, parts, law);
  MeasuredTemperature result;
  double var_degc = 0;
  double var_per_s = 0;
  double count = 0;
  for (const Part& part : parts) {
    MeasuredTemperature::Part& values = result.parts.emplace_back();
    values.first_number = series.blocks[part.first].number;
    for (const State& state : smoothed(series, part, law)) {
      values.values.push_back({state.mean[0], state.mean[1] * kSecondsPerMinute});
      var_degc += state.covariance(0, 0);
      var_per_s += state.covariance(1, 1);
      ++count;
    }
  }
  result.thermometer.resolution_degc = law.step_degc;
  result.thermometer.noise_degc = law.noise_degc;
  set_errors(var_degc / count, var_per_s / count, result.thermometer);
  return result;
}

}  // namespace fogcomp::series
