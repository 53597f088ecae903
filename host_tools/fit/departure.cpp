#include "fit/departure.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "judge/score.hpp"

namespace fogcomp::fit {
namespace {

// Posterior of x for a prior of this covariance, and ln of the rows' probability.
struct Posterior {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
  double log_probability = 0;
};

Posterior posterior(const Eigen::MatrixXd& covariance, const Seen& seen) {
  const Eigen::Index size = covariance.rows();
  const Eigen::PartialPivLU<Eigen::MatrixXd> solved(Eigen::MatrixXd::Identity(size, size) +
                                                    covariance * seen.information);
  Posterior result;
  result.covariance = solved.solve(covariance);
  result.mean = result.covariance * seen.towards;
  result.log_probability = seen.towards.dot(result.mean) / 2 -
                           solved.matrixLU().diagonal().array().abs().log().sum() / 2;
  return result;
}

double log_probability(const Eigen::MatrixXd& covariance, const Seen& seen,
                       const Eigen::VectorXd& widening) {
  return posterior(with_departures(covariance, widening), seen).log_probability -
         widening.array().log().sum();
}

}  // namespace

Eigen::MatrixXd with_departures(const Eigen::MatrixXd& covariance,
                                const Eigen::VectorXd& widening) {
  Eigen::MatrixXd result = covariance;
  result.diagonal().array() *= widening.array().square();
  return result;
}

Eigen::VectorXd widening(const Eigen::MatrixXd& covariance, const Seen& seen) {
  const double step = std::sqrt(2.0);
  constexpr int kMaxSweeps = 20;
  constexpr int kSteps = 60;  // up to 1e9 standard deviations
  Eigen::VectorXd best = Eigen::VectorXd::Ones(covariance.rows());
  double best_log = log_probability(covariance, seen, best);
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    const double before = best_log;
    for (Eigen::Index i = 0; i < best.size(); ++i) {
      Eigen::VectorXd tried = best;
      tried[i] = 1;
      for (int k = 0; k <= kSteps; ++k, tried[i] *= step) {
        const double log = log_probability(covariance, seen, tried);
        if (log <= best_log) continue;
        best_log = log;
        best[i] = tried[i];
      }
    }
    if (best_log == before) break;
  }
  return best;
}

bool Departure::is_certain() const {
  return gain >= judge::kGain;
}

std::vector<Departure> departures(const Eigen::MatrixXd& covariance, const Seen& seen,
                                  const Eigen::VectorXd& widening) {
  std::vector<Departure> all;
  const double with = log_probability(covariance, seen, widening);
  for (Eigen::Index i = 0; i < widening.size(); ++i) {
    Eigen::VectorXd others = widening;
    others[i] = 1;
    const Posterior without = posterior(with_departures(covariance, others), seen);
    const double expected = covariance(i, i) - without.covariance(i, i);
    const double change = without.mean[i];
    // What the rows say nothing of cannot change.
    constexpr double kRounding = 1e-9;
    const double sigmas =
        expected > kRounding * covariance(i, i) ? change / std::sqrt(expected) : 0;
    all.push_back({change, sigmas, with - log_probability(covariance, seen, others)});
  }
  return all;
}

}  // namespace fogcomp::fit
