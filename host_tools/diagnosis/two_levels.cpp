#include "diagnosis/two_levels.hpp"

#include <algorithm>
#include <cmath>

namespace fogcomp {
namespace {

// In units of the white noise of a row.
constexpr double kLeastHeight = 0.5;
constexpr double kMostHeight = 8;
constexpr double kHeightStep = 1.3;
constexpr double kLeastDwell_rows = 8;
constexpr double kDwellStep = 1.8;
constexpr double kLongestDwell = 0.5;      // of the longest stretch
constexpr double kMost = kMostHeight + 4;  // a row beyond counts as if it were there
constexpr int kCentres = 11;               // from half a height below the mean to as much above

// Both processes have mean `centre` and autocovariance (height / 2)^2 decay^rows.
struct Shape {
  double height = 0;
  double decay = 0;
};

// Logarithms of likelihoods, but for what both have in common.

// Forward algorithm.
double log_two_levels(const Eigen::VectorXd& values, const Shape& shape, double centre) {
  const double stay = (1 + shape.decay) / 2;
  const double low = centre - shape.height / 2;
  double log_likelihood = 0;
  double upper = 0.5;
  for (const double value : values) {
    const double ratio = std::exp(shape.height * (value - centre));
    const double likelihood = (1 - upper) + upper * ratio;
    log_likelihood += std::log(likelihood) - (value - low) * (value - low) / 2;
    upper *= ratio / likelihood;
    upper = upper * stay + (1 - upper) * (1 - stay);
  }
  return log_likelihood;
}

// Kalman filter of a first-order Gauss-Markov process.
double log_wander(const Eigen::VectorXd& values, const Shape& shape, double centre) {
  const double variance = shape.height * shape.height / 4;
  double log_likelihood = 0;
  double state = centre;
  double doubt = variance;
  for (const double value : values) {
    const double total = doubt + 1;
    const double innovation = value - state;
    log_likelihood -= (innovation * innovation / total + std::log(total)) / 2;
    const double gain = doubt / total;
    state = centre + shape.decay * (state + gain * innovation - centre);
    doubt = variance + shape.decay * shape.decay * (doubt - gain * doubt - variance);
  }
  return log_likelihood;
}

// With the best centre of every stretch.
template <class Log>
double over_all(const std::vector<Eigen::VectorXd>& stretches, const Shape& shape, Log log) {
  double sum = 0;
  for (const Eigen::VectorXd& values : stretches) {
    double best = -HUGE_VAL;
    for (int i = 0; i < kCentres; ++i) {
      const double away = static_cast<double>(i) / (kCentres - 1) - 0.5;
      best = std::max(best, log(values, shape, values.mean() + away * shape.height));
    }
    sum += best;
  }
  return sum;
}

}  // namespace

TwoLevels find_two_levels(const std::vector<Eigen::VectorXd>& stretches, double white_dph,
                          double row_s) {
  std::vector<Eigen::VectorXd> scaled;
  Eigen::Index longest = 0;
  for (const Eigen::VectorXd& stretch : stretches) {
    const Eigen::VectorXd values = stretch / white_dph;
    scaled.push_back((values.array() - values.mean()).cwiseMax(-kMost).cwiseMin(kMost));
    longest = std::max(longest, stretch.size());
  }
  TwoLevels found;
  double two_levels = -HUGE_VAL;
  double wander = -HUGE_VAL;
  const double longest_dwell = kLongestDwell * static_cast<double>(longest);
  for (double dwell = kLeastDwell_rows; dwell <= longest_dwell; dwell *= kDwellStep) {
    for (double height = kLeastHeight; height <= kMostHeight; height *= kHeightStep) {
      const Shape shape{height, std::exp(-2 / dwell)};
      wander = std::max(wander, over_all(scaled, shape, log_wander));
      const double here = over_all(scaled, shape, log_two_levels);
      if (here <= two_levels) continue;
      two_levels = here;
      found.height_dph = height * white_dph;
      found.dwell_s = dwell * row_s;
    }
  }
  if (two_levels == -HUGE_VAL) return found;
  found.log_odds = two_levels - wander;
  found.gain = 2 * two_levels;
  for (const Eigen::VectorXd& values : scaled) found.gain += values.squaredNorm();
  return found;
}

}  // namespace fogcomp
