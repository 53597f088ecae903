#include "judge/likelihood.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace fogcomp::judge {
namespace {

constexpr double kSomethingElse = 0.15;  // probability that it is missing, beforehand
constexpr double kSmallest = 0.1;
constexpr double kLargest = 10;
constexpr double kFactorOfSize = 3.16;

// What columns of one variance add: to the logarithm of the determinant, and to the square that
// they explain.
struct Added {
  double log_determinant = 0;
  double square = 0;
};

Added added(const Eigen::MatrixXd& own, const Eigen::VectorXd& with_drift, double variance) {
  if (own.cols() == 1) {
    const double determinant = 1 + variance * std::max(0.0, own(0, 0));
    return {std::log(determinant), variance * with_drift[0] * with_drift[0] / determinant};
  }
  if (own.cols() == 2) {
    const double a = 1 + variance * own(0, 0);
    const double b = variance * own(0, 1);
    const double d = 1 + variance * own(1, 1);
    const double determinant = std::max(1.0, a * d - b * b);
    const double x = with_drift[0];
    const double y = with_drift[1];
    return {std::log(determinant),
            variance * (d * x * x - 2 * b * x * y + a * y * y) / determinant};
  }
  const Eigen::LLT<Eigen::MatrixXd> solved(Eigen::MatrixXd::Identity(own.rows(), own.cols()) +
                                           variance * own);
  return {2 * Eigen::MatrixXd(solved.matrixL()).diagonal().array().log().sum(),
          variance * with_drift.dot(solved.solve(with_drift))};
}

}  // namespace

double log_add(double a, double b) {
  const double max = std::max(a, b);
  return max == -HUGE_VAL ? max : max + std::log1p(std::exp(std::min(a, b) - max));
}

void add(const Beside& likely, Beside& sum) {
  for (std::size_t with = 0; with < sum.size(); ++with) {
    sum[with] = log_add(sum[with], likely[with]);
  }
}

Likelihood::Likelihood(const Rivals& rivals) : freedom_(rivals.freedom()) {
  const double most = std::max(kLargest, 3 * rivals.spread());
  for (double size = kSmallest; size < most * kFactorOfSize; size *= kFactorOfSize) {
    sizes_.push_back(size);
  }
  smooth_sizes_.push_back(0);
  for (std::size_t i = 1; i < sizes_.size(); i += 2) smooth_sizes_.push_back(sizes_[i]);
  log_formulas_ = std::log(1 - kSomethingElse);
  log_smooth_ = std::log(kSomethingElse / static_cast<double>(smooth_sizes_.size() - 1));
}

Beside Likelihood::log_prior(std::size_t smooth, double largest) const {
  std::size_t of_errors = 0;
  const double error = kInexact * largest;
  for (std::size_t i = 1; i < smooth_sizes_.size() && error >= kSmallest; ++i) {
    if (i == 1 || smooth_sizes_[i] <= error * kFactorOfSize) of_errors = i;
  }
  return {smooth == of_errors ? log_formulas_ : -HUGE_VAL, smooth > 0 ? log_smooth_ : -HUGE_VAL};
}

double Likelihood::operator()(double log_density, double left) const {
  constexpr double kRounding = 1e-12;  // that an exact model leaves, of a row's noise
  return log_density - freedom_ / 2 * std::log(std::max(left, kRounding * freedom_));
}

double Likelihood::left_for(double log_density, double log_likelihood) const {
  return std::exp(2 * (log_density - log_likelihood) / freedom_);
}

// All sizes are equally probable.
double Likelihood::of_size(double size, double log_density, double left, const Eigen::MatrixXd& own,
                           const Eigen::VectorXd& with_drift) const {
  const Added more = added(own, with_drift, size * size / static_cast<double>(own.cols()));
  return (*this)(log_density - more.log_determinant / 2, left - more.square) -
         std::log(static_cast<double>(sizes_.size()));
}

Beside Likelihood::averaged(const Setting& setting, double log_density, double left, double largest,
                            const Eigen::MatrixXd& own, const Eigen::VectorXd& with_drift) const {
  Beside sum = kNoLikelihood;
  for (const double size : sizes_) {
    const Beside prior = log_prior(setting.smooth_number, std::max(size, largest));
    if (std::max(prior[0], prior[1]) == -HUGE_VAL) continue;
    const double likely = of_size(size, log_density, left, own, with_drift);
    add({prior[0] + likely, prior[1] + likely}, sum);
  }
  return sum;
}

double Likelihood::averaged(double log_density, double left, const Eigen::MatrixXd& own,
                            const Eigen::VectorXd& with_drift) const {
  double sum = -HUGE_VAL;
  for (const double size : sizes_) {
    sum = log_add(sum, of_size(size, log_density, left, own, with_drift));
  }
  return sum;
}

}  // namespace fogcomp::judge
