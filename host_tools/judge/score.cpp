#include "judge/score.hpp"

#include <algorithm>
#include <cmath>

namespace fogcomp::judge {

bool Promise::is_broken() const {
  return squares - expected >= kSigmas * std::sqrt(variance);
}

void Promise::add(const Promise& other) {
  squares += other.squares;
  expected += other.expected;
  variance += other.variance;
}

// With the rows before known, a row's gain has the variance v (m - M)^2 / V^2 + (v / V - 1)^2 / 2
// if the one with mean m and variance v is right, and not that with M and V.
Score score(const Eigen::VectorXd& measured_dph, const Foretold& before, const Foretold& after) {
  Score score;
  double variance = 0;
  for (Eigen::Index i = 0; i < measured_dph.size(); ++i) {
    const double v0 = before.variance[i];
    const double v1 = after.variance[i];
    if (v0 <= 0 || v1 <= 0) continue;
    const double left0 = measured_dph[i] - before.mean_dph[i];
    const double left1 = measured_dph[i] - after.mean_dph[i];
    score.gain += (left0 * left0 / v0 - left1 * left1 / v1 + std::log(v0 / v1)) / 2;
    const auto [v, other] = std::minmax(v0, v1);
    const double apart = (left0 - left1) / other;
    variance += v * apart * apart + std::pow(v / other - 1, 2) / 2;
  }
  score.standard_error = std::sqrt(variance);
  return score;
}

}  // namespace fogcomp::judge
