#include "judge/prediction.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/least_squares.hpp"
#include "support/units.hpp"

namespace fogcomp::judge {
namespace {

// Grid of each level: from a share of the white noise that the slowest mode hardly shows up to one
// that exceeds it in nearly all; equal steps of the logarithm are equally probable beforehand.
constexpr double kBandsPerOctave = 12;
constexpr double kHardlySeen = 0.03;
constexpr double kStepOfFlicker = 2;
constexpr double kStepOfWalk = 4;
constexpr double kStepOfTemperature = 2;
constexpr double kMaxTemperature = 256;
constexpr double kRounding = 1e-14;
constexpr double kNegligible = 1e-6;  // of the largest probability

// Noise relative to the white noise of a row.
struct Ratios {
  double flicker = 0;  // variance of a mode at an angle of one per row
  double walk = 0;
  double temperature = 0;  // largest density of what its errors make of the drift
  double turn_on = 0;      // variance
};

struct Solution {
  Ratios ratios;
  double log_probability = 0;
  double white = 0;  // variance of a row
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
};

std::vector<double> geometric(double min, double max, double step) {
  std::vector<double> values;
  for (double value = min; value < max; value *= step) values.push_back(value);
  return values;
}

// The linear problem for every noise, from the products over bands of modes.
class Problem {
 public:
  explicit Problem(const Rows& rows)
      : rows_(rows),
        own_(rows.columns.cols()),
        power_ons_(static_cast<Eigen::Index>(rows.power_ons.size())),
        bands_(rows.stretches, kBandsPerOctave) {
    Eigen::MatrixXd all = bridged(
        rows, side_by_side({rows.columns, power_on_columns(rows), rows.drift_dph}, rows.size()));
    columns_ = all.cols();
    unit_ = all.colwise().norm().transpose() / std::sqrt(static_cast<double>(all.rows()));
    unit_ = (unit_.array() > 0).select(unit_, 1);
    all.array().rowwise() /= unit_.transpose().array();
    const Eigen::MatrixXd modes = bands_.modes(all);
    products_ = bands_.products(modes, modes);
    const auto excluded = static_cast<double>((rows.weights.array() <= 0).count());
    excluded_share_ = excluded / static_cast<double>(rows.weights.size());
    temperature_ = density_of_temperature(rows, bands_);
    most_of_temperature_ = temperature_.maxCoeff();
    if (most_of_temperature_ > 0) temperature_ /= most_of_temperature_;
    white_ = bands_.mean_of_fast_modes(products_.bottomRows(1).transpose()) *
             std::pow(unit_[columns_ - 1], 2);
  }

  // Most probable noise first.
  std::vector<Solution> solve() {
    const double slowest = bands_.angle().minCoeff();
    const std::vector<double> flickers =
        geometric(kHardlySeen * slowest, kMostFlicker, kStepOfFlicker);
    const std::vector<double> walks =
        geometric(kHardlySeen * slowest * slowest, kMostWalk, kStepOfWalk);
    const double expected = most_of_temperature_ / white_;
    const std::vector<double> temperatures =
        expected < kHardlySeen ? std::vector<double>{expected}
                               : geometric(kHardlySeen, kMaxTemperature, kStepOfTemperature);
    std::vector<Solution> solutions;
    for (const double temperature : temperatures) add_all(flickers, walks, temperature, solutions);
    keep_probable(solutions);
    for (Solution& solution : solutions) complete(solution);
    return solutions;
  }

  Eigen::Index own() const { return own_; }
  Eigen::Index power_ons() const { return power_ons_; }

 private:
  Eigen::ArrayXd density_of_noise(const Ratios& ratios) const {
    return bands_.noise_density(ratios.flicker, ratios.walk) + ratios.temperature * temperature_;
  }

  void add_all(const std::vector<double>& flickers, const std::vector<double>& walks,
               double temperature, std::vector<Solution>& solutions) const {
    Eigen::MatrixXd weights(bands_.angle().size(),
                            static_cast<Eigen::Index>(flickers.size() * walks.size()));
    std::vector<Ratios> noises;
    Eigen::VectorXd log_density(weights.cols());
    for (const double flicker : flickers) {
      for (const double walk : walks) {
        const auto at = static_cast<Eigen::Index>(noises.size());
        noises.push_back({flicker, walk, temperature, 0});
        const Eigen::ArrayXd density = density_of_noise(noises.back());
        weights.col(at) = density.inverse();
        log_density[at] = (bands_.count() * density.log()).sum();
      }
    }
    const Eigen::MatrixXd sums = products_ * weights;
    for (std::size_t i = 0; i < noises.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      const Eigen::Map<const Eigen::MatrixXd> products(&sums(0, at), columns_, columns_);
      for (const TurnOn& turn_on : turn_ons(products)) {
        Solution solution;
        solution.ratios = noises[i];
        solution.ratios.turn_on = turn_on.variance;
        solution.log_probability = turn_on.log_prior - log_density[at] / 2;
        judge(with_priors(products, turn_on.variance), solution);
        solutions.push_back(std::move(solution));
      }
    }
  }

  static void keep_probable(std::vector<Solution>& solutions) {
    const auto more_probable = [](const Solution& a, const Solution& b) {
      return a.log_probability > b.log_probability;
    };
    std::sort(solutions.begin(), solutions.end(), more_probable);
    const double least = solutions.front().log_probability + std::log(kNegligible);
    while (solutions.size() > 1 && !(solutions.back().log_probability >= least)) {
      solutions.pop_back();
    }
  }

  struct TurnOn {
    double variance = 0;
    double log_prior = 0;
  };
  // Half-Cauchy about the spread that the biases show: scale-free, and without a largest value.
  std::vector<TurnOn> turn_ons(const Eigen::MatrixXd& products) const {
    if (power_ons_ == 0) return {{0, 0}};
    constexpr int kEachSide = 6;
    const double scale = shown_spread(products);
    std::vector<TurnOn> all;
    for (int i = -kEachSide; i <= kEachSide; ++i) {
      const double relative = std::exp2(i / 1.5);
      all.push_back(
          {std::pow(scale * relative, 2), std::log(relative / (1 + relative * relative))});
    }
    return all;
  }

  // Rms of the power-ons' biases, relative to the white noise, if they may be anything, but at
  // least their uncertainty.
  double shown_spread(const Eigen::MatrixXd& products) const {
    constexpr double kAny = 1e4;  // standard deviations of white noise
    const Eigen::Index size = columns_ - 1;
    const Eigen::MatrixXd all = with_priors(products, kAny * kAny);
    const Eigen::LDLT<Eigen::MatrixXd> solved(all.topLeftCorner(size, size));
    const Eigen::VectorXd biases = solved.solve(all.col(size).head(size)).segment(own_, power_ons_);
    const Eigen::ArrayXd relative = biases.array() / unit_.segment(own_, power_ons_).array();
    const double mean = relative.mean();
    const double spread =
        (relative - mean).square().sum() / std::max(1.0, static_cast<double>(power_ons_ - 1));
    double longest = 0;
    for (const recording::RowRange& range : rows_.power_ons) {
      longest = std::max(longest, static_cast<double>(range.size()));
    }
    return std::sqrt(std::max(spread, 1 / longest));
  }

  // In the units of the columns, relative to the white noise.
  Eigen::MatrixXd with_priors(const Eigen::MatrixXd& products, double turn_on) const {
    Eigen::MatrixXd all = products;
    const double measured = std::pow(unit_[columns_ - 1], 2);
    for (Eigen::Index i = 0; i < own_ + power_ons_; ++i) {
      const double variance = prior_variance(i, turn_on);
      if (variance > 0) all(i, i) += 1 / (variance * unit_[i] * unit_[i]);
    }
    all.col(columns_ - 1) *= std::sqrt(measured / white_);
    all.row(columns_ - 1) *= std::sqrt(measured / white_);
    return all;
  }

  double prior_variance(Eigen::Index i, double turn_on) const {
    if (i >= own_) return turn_on;
    return std::pow(rows_.prior_sigma[i], 2) / white_;
  }

  // Probability of the noise, the white level integrated out.
  void judge(const Eigen::MatrixXd& all, Solution& solution) const {
    const Eigen::Index size = columns_ - 1;
    const Eigen::LDLT<Eigen::MatrixXd> solved(all.topLeftCorner(size, size));
    const Eigen::VectorXd with = all.col(size).head(size);
    // A model that is exact leaves rounding.
    const double square =
        std::max(all(size, size) - with.dot(solved.solve(with)), kRounding * all(size, size));
    double flat = 0;
    double log_determinant = 0;
    for (Eigen::Index i = 0; i < size; ++i) {
      log_determinant += std::log(std::max(solved.vectorD()[i], 1e-300));
      const double variance = prior_variance(i, solution.ratios.turn_on);
      if (variance > 0) {
        log_determinant += std::log(variance * unit_[i] * unit_[i]);
      } else {
        ++flat;
      }
    }
    const double freedom = std::max(1.0, bands_.count().sum() * (1 - excluded_share_) - flat);
    solution.log_probability -= (log_determinant + freedom * std::log(square)) / 2;
    solution.white = white_ * square / freedom;
    if (!(most_of_temperature_ > 0)) return;
    const double factor = solution.ratios.temperature * solution.white / most_of_temperature_;
    solution.log_probability += log_prior_of_temperature(factor);
  }

  // Means and covariance in deg/h, of the model's unknowns and of the power-ons.
  void complete(Solution& solution) const {
    const Eigen::ArrayXd density = density_of_noise(solution.ratios);
    const Eigen::MatrixXd all = with_priors(
        weighted(products_, density.inverse().matrix(), columns_), solution.ratios.turn_on);
    const Eigen::Index size = columns_ - 1;
    const Eigen::LDLT<Eigen::MatrixXd> solved(all.topLeftCorner(size, size));
    const Eigen::VectorXd scale = unit_.head(size).cwiseInverse();
    solution.covariance =
        solution.white * (scale.asDiagonal() * solved.solve(Eigen::MatrixXd::Identity(size, size)) *
                          scale.asDiagonal())
                             .eval();
    std::vector<Eigen::Index> sought;
    for (Eigen::Index i = 0; i < size; ++i) {
      if (i < rows_.first_found || i >= own_) sought.push_back(i);
    }
    const Eigen::MatrixXd of_sought = all(sought, sought);
    const Eigen::VectorXd with = all(sought, size);
    const Eigen::VectorXd found = Eigen::LDLT<Eigen::MatrixXd>(of_sought).solve(with);
    solution.mean = Eigen::VectorXd::Zero(size);
    solution.mean(sought) = found;
    solution.mean = std::sqrt(white_) * solution.mean.cwiseProduct(scale);
  }

  const Rows& rows_;
  Eigen::Index own_;
  Eigen::Index power_ons_;
  Eigen::Index columns_ = 0;  // the model's, one per power-on, the measured drift
  Eigen::VectorXd unit_;      // rms of each
  ModeBands bands_;
  Eigen::MatrixXd products_;  // of all columns, in each band
  double excluded_share_ = 0;
  Eigen::ArrayXd temperature_;      // of the temperature's errors, 1 at most
  double most_of_temperature_ = 0;  // (deg/h)^2
  double white_ = 0;                // to which priors are related
};

}  // namespace

Prediction::Prediction(const Rows& rows) {
  Problem problem(rows);
  const std::vector<Solution> solutions = problem.solve();
  double total = 0;
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(solutions.front().mean.size());
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(mean.size(), mean.size());
  double white = 0;
  double flicker = 0;
  double walk = 0;
  double turn_on = 0;
  for (const Solution& solution : solutions) {
    const double probability =
        std::exp(solution.log_probability - solutions.front().log_probability);
    const Eigen::VectorXd from_first = solution.mean - solutions.front().mean;
    total += probability;
    mean += probability * from_first;
    square += probability * (solution.covariance + from_first * from_first.transpose());
    white += probability * solution.white;
    flicker += probability * solution.white * solution.ratios.flicker;
    walk += probability * solution.white * solution.ratios.walk;
    turn_on += probability * solution.white * solution.ratios.turn_on;
  }
  mean /= total;
  const Eigen::Index own = problem.own();
  covariance_ = (square / total - mean * mean.transpose()).topLeftCorner(own, own);
  mean += solutions.front().mean;
  mean_ = mean.head(own);
  turn_on_biases_ = mean.tail(problem.power_ons());
  noise_.white_dph = std::sqrt(white / total);
  noise_.flicker_dph = std::sqrt(flicker / total);
  noise_.walk_dph_per_rth = std::sqrt(walk / total / rows.row_s * kSecondsPerHour);
  noise_.turn_on_dph = std::sqrt(turn_on / total);
}

Prediction Prediction::of(const Eigen::VectorXd& origin, const Eigen::MatrixXd& slopes) const {
  Prediction other = *this;
  other.mean_ = origin + slopes * mean_;
  other.covariance_ = slopes * covariance_ * slopes.transpose();
  return other;
}

}  // namespace fogcomp::judge
