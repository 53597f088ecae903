#include "series/temperature_smoother.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

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

TemperatureState predicted(const TemperatureState& now, const Eigen::Matrix3d& f,
                           const Eigen::Matrix3d& added) {
  return {f * now.mean, f * now.covariance * f.transpose() + added};
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
  // One reading in a million is wrong, and then it says anything within 100 degC.
  constexpr double kWrongPerDegc = 1e-8;
  const double noise = law.noise_degc * law.noise_degc;
  const double sigma = std::sqrt(variance + noise);
  const double from_reading = (reading_degc - mean_degc) / sigma;
  Site site{1 / noise, reading_degc / noise};
  double right = density(from_reading) / sigma;
  double wrong = kWrongPerDegc;
  if (law.step_degc > 0) {
    const double half = law.step_degc / 2 / sigma;
    const Truncated inside = truncated(from_reading - half, from_reading + half);
    site.precision = (1 - inside.variance) / (noise + variance * inside.variance);
    const double mean = mean_degc + variance / sigma * inside.mean;
    site.shift = site.precision * mean + inside.mean / sigma;
    right = std::exp(inside.log_probability);
    wrong *= law.step_degc;
  }
  const double is_right = right / (right + wrong);
  return {{is_right * site.precision, is_right * site.shift}, std::log(right + wrong)};
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

// The temperature is what two of the first three readings agree on, to their difference: any one of
// them may be wrong. Nothing is known of its rate but what a chamber can do.
TemperatureState at_first(const std::vector<double>& readings, const TemperatureLaw& law) {
  constexpr double kMaxPerMin = 5;
  constexpr double kFastest_s = 10;
  std::vector<double> three;
  for (std::size_t i = 0; i < readings.size() && three.size() < 3; ++i) {
    if (!std::isnan(readings[i])) three.push_back(readings[i]);
  }
  std::sort(three.begin(), three.end());
  const double middle = three[three.size() / 2];
  const double apart = std::min(middle - three.front(), three.back() - middle);
  const double per_s = kMaxPerMin / kSecondsPerMinute;
  const Eigen::Vector3d sigma(std::max({apart, law.step_degc, law.noise_degc}), per_s,
                              per_s / kFastest_s);
  return {{middle, 0, 0}, sigma.cwiseAbs2().asDiagonal()};
}

class Smoother {
 public:
  Smoother(const TemperatureReadings& readings, const TemperatureLaw& law)
      : law_(law),
        interval_s_(readings.interval_s),
        transition_(transition(interval_s_)),
        first_(at_first(readings.degc, law)),
        readings_(readings.degc),
        sites_(readings_.size()),
        later_(readings_.size(), {Eigen::Matrix3d::Zero(), Eigen::Vector3d::Zero()}),
        stretches_{{0, readings_.size(), law.walk}} {}

  // Calls visit(state) for each reading, in order.
  void run(const std::function<void(const TemperatureState&)>& visit) {
    constexpr int kTurns = 4;
    take_as_measurements();
    backward();
    forward([](const Passed&) {});
    backward();
    divide();
    for (int turn = 0; turn < kTurns; ++turn) {
      backward();
      find_walks();
    }
    backward();
    forward([&](const Passed& passed) { visit(passed.state); });
  }

 private:
  // Of a state: its precision, and that times its mean.
  struct Information {
    Eigen::Matrix3d matrix;
    Eigen::Vector3d vector;
  };
  // Readings to each of which a walk of one size leads.
  struct Stretch {
    std::size_t first = 0;
    std::size_t end = 0;
    double walk = 0;
  };
  // A reading that has been passed.
  struct Passed {
    std::size_t reading;
    const TemperatureState& state;     // from all readings
    const TemperatureState& expected;  // from the earlier ones
    const Eigen::Matrix3d& added;      // by the walk that led to it
  };
  // Of the walk's steps.
  struct Shown {
    double square = 0;  // of what they were, relative to what the walk lets expect
    double told = 0;    // how many of their three numbers the readings tell
  };

  // A start from which the turns converge on long soaks, too: readings within the time in which the
  // walk crosses a step are one measurement of the place within it.
  void take_as_measurements() {
    const double variance =
        law_.step_degc * law_.step_degc / 12 + law_.noise_degc * law_.noise_degc;
    const double crossing_s = std::pow(20 * variance / law_.walk, 0.2);
    const double precision = std::min(1.0, interval_s_ / crossing_s) / variance;
    for (std::size_t i = 0; i < readings_.size(); ++i) {
      if (!std::isnan(readings_[i])) sites_[i] = {precision, precision * readings_[i]};
    }
  }

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

  // Calls visit(Passed) for each reading, from the first on, with what later ones said last.
  template <class Visit>
  void forward(const Visit& visit) {
    TemperatureState before = first_;
    for (const Stretch& stretch : stretches_) {
      const Eigen::Matrix3d added = added_by(interval_s_, stretch.walk);
      for (std::size_t i = stretch.first; i < stretch.end; ++i) {
        if (i > 0) before = predicted(before, transition_, added);
        const TemperatureState expected = before;
        TemperatureState state = with(before, later_[i]);
        if (!std::isnan(readings_[i])) {
          sites_[i] = seen(readings_[i], law_, state.mean[0], state.covariance(0, 0)).site;
          take(sites_[i], state);
          take(sites_[i], before);
        }
        visit(Passed{i, state, expected, added});
      }
    }
  }

  void backward() {
    for (std::size_t s = stretches_.size(); s-- > 0;) {
      const Stretch& stretch = stretches_[s];
      const Eigen::Matrix3d added = added_by(interval_s_, stretch.walk);
      for (std::size_t i = stretch.end - 1; i >= std::max<std::size_t>(stretch.first, 1); --i) {
        const Information all = from(i);
        const Eigen::Matrix3d left = shrunk(all.matrix, added);
        later_[i - 1] = {transition_.transpose() * left * transition_,
                         transition_.transpose() * (all.vector - left * (added * all.vector))};
      }
    }
  }

  // What a reading and those after it say of the step to it.
  Shown shown_at(const Passed& passed) const {
    if (passed.reading == 0) return {};
    const Information all = from(passed.reading);
    const Eigen::Vector3d pull = all.vector - all.matrix * passed.state.mean;
    return {pull.dot(passed.added * pull),
            (passed.added * shrunk(all.matrix, passed.expected.covariance)).trace()};
  }

  // Stretches in which the readings tell so much of the walk; the last one also has what is left.
  void divide() {
    constexpr double kTold = 4;
    std::vector<Stretch> stretches{{0, readings_.size(), law_.walk}};
    double told = 0;
    forward([&](const Passed& passed) {
      told += shown_at(passed).told;
      if (told < kTold) return;
      stretches.back().end = passed.reading + 1;
      stretches.push_back({passed.reading + 1, readings_.size(), law_.walk});
      told = 0;
    });
    if (stretches.size() > 1) stretches.pop_back();
    stretches.back().end = readings_.size();
    stretches_ = std::move(stretches);
  }

  // Beside one step as large as everywhere.
  void find_walks() {
    std::vector<Shown> shown;
    for (const Stretch& stretch : stretches_) shown.push_back({law_.walk / stretch.walk, 1});
    std::size_t at = 0;
    forward([&](const Passed& passed) {
      if (passed.reading == stretches_[at].end) ++at;
      const Shown now = shown_at(passed);
      shown[at].square += now.square;
      shown[at].told += now.told;
    });
    for (std::size_t s = 0; s < shown.size(); ++s) {
      stretches_[s].walk *= shown[s].square / shown[s].told;
    }
  }

  const TemperatureLaw& law_;
  double interval_s_;
  Eigen::Matrix3d transition_;
  TemperatureState first_;
  const std::vector<double>& readings_;
  std::vector<Site> sites_;
  std::vector<Information> later_;  // what later readings say
  std::vector<Stretch> stretches_;
};

}  // namespace

double log_likelihood(const TemperatureReadings& readings, std::size_t every,
                      const TemperatureLaw& law) {
  double sum = 0;
  TemperatureState state = at_first(readings.degc, law);
  std::size_t before = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < readings.degc.size(); ++i) {
    if (std::isnan(readings.degc[i]) || count++ % every != 0) continue;
    const double dt = static_cast<double>(i - before) * readings.interval_s;
    state = predicted(state, transition(dt), added_by(dt, law.walk));
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
