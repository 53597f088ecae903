#include "series/temperature_smoother.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

#include "support/units.hpp"

namespace fogcomp::series {
namespace {

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

TemperatureState predicted(const TemperatureState& now, double dt, double walk) {
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

Seen seen(double reading_degc, const TemperatureLaw& law, double mean_degc, double variance) {
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
void take(const Site& site, TemperatureState& state) {
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
TemperatureState at_first(double reading_degc, const TemperatureLaw& law) {
  constexpr double kMaxPerMin = 5;
  constexpr double kFastest_s = 10;
  const double degc = std::max(law.step_degc, law.noise_degc);
  const double per_s = kMaxPerMin / kSecondsPerMinute;
  const Eigen::Vector3d sigma(degc, per_s, per_s / kFastest_s);
  return {{reading_degc, 0, 0}, sigma.cwiseAbs2().asDiagonal()};
}

class Smoother {
 public:
  using Visit = std::function<void(const TemperatureState&)>;
  Smoother(const TemperatureReadings& readings, const TemperatureLaw& law)
      : law_(law),
        interval_s_(readings.interval_s),
        first_(at_first(readings.degc[0], law)),
        readings_(readings.degc),
        sites_(readings_.size()),
        later_(readings_.size(), {Eigen::Matrix3d::Zero(), Eigen::Vector3d::Zero()}),
        stretches_{{0, readings_.size(), law.walk, {}}} {}

  // Calls visit(state) for each reading, in order.
  void run(const Visit& visit) {
    constexpr int kTurns = 5;
    forward({});
    backward();
    forward({});
    divide();
    for (int turn = 1; turn < kTurns; ++turn) {
      backward();
      forward({});
      for (Stretch& stretch : stretches_) stretch.walk *= stretch.shown.square / stretch.shown.told;
    }
    backward();
    forward(visit);
  }

 private:
  static constexpr double kTold = 4;  // numbers of a stretch that the readings tell

  // Of a state: its precision, and that times its mean.
  struct Information {
    Eigen::Matrix3d matrix;
    Eigen::Vector3d vector;
  };
  // Of the walk's steps.
  struct Shown {
    double square = 0;  // of what they were, relative to what the walk lets expect
    double told = 0;    // how many of their three numbers the readings tell
  };
  struct Stretch {
    std::size_t first = 0;
    std::size_t end = 0;
    double walk = 0;  // that leads to each of its readings
    Shown shown;      // beside one step as large as everywhere
  };

  Information from(std::size_t i) const {
    Information all = later_[i];
    all.matrix(0, 0) += sites_[i].precision;
    all.vector[0] += sites_[i].shift;
    return all;
  }

  static TemperatureState with(const TemperatureState& state, const Information& more) {
    const Eigen::Matrix3d covariance = shrunk(state.covariance, more.matrix);
    return {state.mean + covariance * (more.vector - more.matrix * state.mean), covariance};
  }

  // From the first on, with what later readings said last.
  void forward(const Visit& visit) {
    TemperatureState before = first_;
    divisions_.clear();
    told_ = 0;
    for (Stretch& stretch : stretches_) {
      stretch.shown = {law_.walk / stretch.walk, 1};
      for (std::size_t i = stretch.first; i < stretch.end; ++i) {
        if (i > 0) before = predicted(before, interval_s_, stretch.walk);
        const TemperatureState expected = before;
        TemperatureState state = with(before, later_[i]);
        if (!std::isnan(readings_[i])) {
          sites_[i] = seen(readings_[i], law_, state.mean[0], state.covariance(0, 0)).site;
          take(sites_[i], state);
          take(sites_[i], before);
        }
        if (i > 0) look(i, state, expected, stretch);
        if (visit) visit(state);
      }
    }
  }

  // What this and later readings say of the step to this one, before which `expected` was known.
  void look(std::size_t i, const TemperatureState& state, const TemperatureState& expected,
            Stretch& stretch) {
    const Information all = from(i);
    const Eigen::Matrix3d added = added_by(interval_s_, stretch.walk);
    const Eigen::Vector3d pull = all.vector - all.matrix * state.mean;
    const double told = (added * shrunk(all.matrix, expected.covariance)).trace();
    stretch.shown.square += pull.dot(added * pull);
    stretch.shown.told += told;
    told_ += told;
    if (told_ < kTold) return;
    divisions_.push_back(i + 1);
    told_ = 0;
  }

  // The last one also has what is left.
  void divide() {
    stretches_.clear();
    std::size_t first = 0;
    for (std::size_t k = 0; k < divisions_.size(); ++k) {
      const std::size_t end = k + 1 < divisions_.size() ? divisions_[k] : readings_.size();
      stretches_.push_back({first, end, law_.walk, {}});
      first = end;
    }
    if (stretches_.empty()) stretches_.push_back({0, readings_.size(), law_.walk, {}});
  }

  void backward() {
    const Eigen::Matrix3d f = transition(interval_s_);
    auto stretch = stretches_.rbegin();
    for (std::size_t i = later_.size() - 1; i > 0; --i) {
      if (i < stretch->first) ++stretch;
      const Information all = from(i);
      const Eigen::Matrix3d added = added_by(interval_s_, stretch->walk);
      const Eigen::Matrix3d left = shrunk(all.matrix, added);
      later_[i - 1] = {f.transpose() * left * f,
                       f.transpose() * (all.vector - left * (added * all.vector))};
    }
  }

  const TemperatureLaw& law_;
  double interval_s_;
  TemperatureState first_;
  const std::vector<double>& readings_;
  std::vector<Site> sites_;
  std::vector<Information> later_;  // what later readings say
  std::vector<Stretch> stretches_;
  std::vector<std::size_t> divisions_;  // where a stretch might end
  double told_ = 0;                     // since the last one
};

}  // namespace

double log_likelihood(const TemperatureReadings& readings, std::size_t every,
                      const TemperatureLaw& law) {
  double sum = 0;
  TemperatureState state = at_first(readings.degc[0], law);
  std::size_t before = 0;
  std::size_t count = 0;
  for (std::size_t i = 1; i < readings.degc.size(); ++i) {
    if (std::isnan(readings.degc[i]) || ++count % every != 0) continue;
    state = predicted(state, static_cast<double>(i - before) * readings.interval_s, law.walk);
    before = i;
    const Seen now = seen(readings.degc[i], law, state.mean[0], state.covariance(0, 0));
    take(now.site, state);
    sum += now.log_probability;
  }
  return sum;
}

void smooth(const TemperatureReadings& readings, const TemperatureLaw& law,
            const std::function<void(const TemperatureState&)>& visit) {
  Smoother(readings, law).run(visit);
}

}  // namespace fogcomp::series
