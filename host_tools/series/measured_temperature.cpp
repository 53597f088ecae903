#include "series/measured_temperature.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>

#include "series/block_walk.hpp"
#include "support/units.hpp"

namespace fogcomp::series {
namespace {

// Noise and walk are found to this factor, from at most so many readings.
constexpr double kFactor = 2;
constexpr std::size_t kReadings = 4000;
constexpr double kLeast = 1e-18;       // of noise (degC) and walk: none
constexpr double kFinest_degc = 1e-4;  // of noise: what is finer costs digits
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

// Covariance that the walk adds to a state.
Eigen::Matrix3d added_by(double dt, double walk) {
  const double d2 = dt * dt;
  Eigen::Matrix3d added;
  added << d2 * d2 / 20, d2 * dt / 8, d2 / 6, d2 * dt / 8, d2 / 3, dt / 2, d2 / 6, dt / 2, 1;
  return walk * dt * added;
}

State predicted(const State& now, double dt, double walk) {
  const Eigen::Matrix3d f = transition(dt);
  return {f * now.mean, f * now.covariance * f.transpose() + added_by(dt, walk)};
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

// What a reading says of the temperature: as much as a measurement of this precision.
struct Site {
  double precision = 0;  // 1 / degC^2
  double shift = 0;      // precision * measured value
};

// What one reading says beside all others, of which the temperature has a mean and a variance, and
// the ln of its probability (of its density without steps).
struct Seen {
  Site site;
  double log_probability = 0;
};

Seen seen(double reading_degc, const Law& law, double mean_degc, double variance) {
  const double noise = law.noise_degc * law.noise_degc;
  const double sigma = std::sqrt(variance + noise);
  const double from_reading = (reading_degc - mean_degc) / sigma;
  if (!(law.step_degc > 0)) {
    return {{1 / noise, reading_degc / noise}, -from_reading * from_reading / 2 - std::log(sigma)};
  }
  const double half = law.step_degc / 2 / sigma;
  const Truncated inside = truncated(from_reading - half, from_reading + half);
  Site site;
  site.precision = (1 - inside.variance) / (noise + variance * inside.variance);
  const double mean = mean_degc + variance / sigma * inside.mean;
  site.shift = site.precision * mean + inside.mean / sigma;
  return {site, inside.log_probability};
}

// The covariance as a sum of squares: it stays positive where nearly all of it goes (Joseph's
// form).
void take(const Site& site, State& state) {
  const double sum = 1 + site.precision * state.covariance(0, 0);
  const Eigen::Vector3d gain = state.covariance.col(0) / sum;
  state.mean += (site.shift - site.precision * state.mean[0]) * gain;
  Eigen::Matrix3d left = Eigen::Matrix3d::Identity();
  left.col(0) -= site.precision * gain;
  state.covariance =
      left * state.covariance * left.transpose() + site.precision * gain * gain.transpose();
}

// Lower triangular root of a covariance; what rounding has made negative is 0.
Eigen::Matrix3d root_of(const Eigen::Matrix3d& square) {
  Eigen::Matrix3d root = Eigen::Matrix3d::Zero();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double left = square(k, k) - root.row(k).head(k).squaredNorm();
    if (!(left > 0)) continue;
    root(k, k) = std::sqrt(left);
    for (Eigen::Index i = k + 1; i < 3; ++i) {
      root(i, k) = (square(i, k) - root.row(i).head(k).dot(root.row(k).head(k))) / root(k, k);
    }
  }
  return root;
}

// (square^-1 + more)^-1, with the digits that both have.
Eigen::Matrix3d shrunk(const Eigen::Matrix3d& square, const Eigen::Matrix3d& more) {
  const Eigen::Matrix3d root = root_of(square);
  const Eigen::Matrix3d sum = Eigen::Matrix3d::Identity() + root.transpose() * more * root;
  return root * sum.llt().solve(root.transpose());
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
      const Seen now = seen(block.means.temperature, law, state.mean[0], state.covariance(0, 0));
      take(now.site, state);
      sum += now.log_probability;
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
      if (tried.noise_degc < std::max(kFinest_degc, kSharpest * tried.step_degc)) return any;
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

// States of the blocks of a part from all its readings. A reading that stands is the same knowledge
// seen again: each one's share is what it adds to all others, earlier and later (expectation
// propagation, Minka 2001, on a chain), not to the earlier ones alone.
class Smoother {
 public:
  Smoother(const BlockSeries& series, const Part& part, const Law& law)
      : law_(law),
        block_s_(series.block_s),
        first_(at_first(series.blocks[part.first].means.temperature, law)) {
    const std::int64_t first = series.blocks[part.first].number;
    const auto size = static_cast<std::size_t>(series.blocks[part.end - 1].number - first) + 1;
    readings_.assign(size, NAN);
    for (std::size_t i = part.first; i < part.end; ++i) {
      const BlockSeries::Block& block = series.blocks[i];
      readings_[static_cast<std::size_t>(block.number - first)] = block.means.temperature;
    }
    sites_.resize(size);
    later_.assign(size, {Eigen::Matrix3d::Zero(), Eigen::Vector3d::Zero()});
  }

  // One for each block number.
  std::vector<State> states() {
    constexpr int kMaxSweeps = 8;
    constexpr double kSettled = 0.1;  // standard deviations
    std::vector<State> states(readings_.size());
    forward(states);
    for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
      backward();
      if (forward(states) < kSettled) break;
    }
    return states;
  }

 private:
  // Of a state: its precision, and that times its mean.
  struct Information {
    Eigen::Matrix3d matrix;
    Eigen::Vector3d vector;
  };

  static State with(const State& state, const Information& more) {
    const Eigen::Matrix3d covariance = shrunk(state.covariance, more.matrix);
    return {state.mean + covariance * (more.vector - more.matrix * state.mean), covariance};
  }

  // Returns by how many standard deviations a temperature has changed at most.
  double forward(std::vector<State>& states) {
    double most = 0;
    State before = first_;
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (i > 0) before = predicted(before, block_s_, law_.walk);
      states[i] = with(before, later_[i]);
      if (!std::isnan(readings_[i])) {
        State earlier = states[i];
        take(sites_[i], earlier);
        sites_[i] = seen(readings_[i], law_, states[i].mean[0], states[i].covariance(0, 0)).site;
        take(sites_[i], states[i]);
        take(sites_[i], before);
        most = std::max(most, std::abs(states[i].mean[0] - earlier.mean[0]) /
                                  std::sqrt(states[i].covariance(0, 0)));
      }
    }
    return most;
  }

  void backward() {
    const Eigen::Matrix3d f = transition(block_s_);
    const Eigen::Matrix3d added = added_by(block_s_, law_.walk);
    for (std::size_t i = later_.size() - 1; i > 0; --i) {
      Information all = later_[i];
      all.matrix(0, 0) += sites_[i].precision;
      all.vector[0] += sites_[i].shift;
      const Eigen::Matrix3d left = shrunk(all.matrix, added);
      later_[i - 1] = {f.transpose() * left * f,
                       f.transpose() * (all.vector - left * (added * all.vector))};
    }
  }

  Law law_;
  double block_s_;
  State first_;
  std::vector<double> readings_;  // NaN: none
  std::vector<Site> sites_;
  std::vector<Information> later_;  // what later readings say
};

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
  Law law{series.temperature_step_degc, std::max(0.1 * series.temperature_step_degc, 1e-3), 1e-9};
  law = most_probable(series, parts, law);
  MeasuredTemperature result;
  double var_degc = 0;
  double var_per_s = 0;
  double count = 0;
  for (const Part& part : parts) {
    MeasuredTemperature::Part& values = result.parts.emplace_back();
    values.first_number = series.blocks[part.first].number;
    for (const State& state : Smoother(series, part, law).states()) {
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
