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

// What columns of one variance add: a factor of the determinant, and the square that they explain.
struct Added {
  double determinant = 1;
  double square = 0;
};

Added added(const Eigen::Ref<const Eigen::MatrixXd>& own,
            const Eigen::Ref<const Eigen::VectorXd>& with_drift, double variance) {
  if (own.cols() == 1) {
    const double determinant = 1 + variance * std::max(0.0, own(0, 0));
    return {determinant, variance * with_drift[0] * with_drift[0] / determinant};
  }
  if (own.cols() == 2) {
    const double a = 1 + variance * own(0, 0);
    const double b = variance * own(0, 1);
    const double d = 1 + variance * own(1, 1);
    const double determinant = std::max(1.0, a * d - b * b);
    const double x = with_drift[0];
    const double y = with_drift[1];
    return {determinant, variance * (d * x * x - 2 * b * x * y + a * y * y) / determinant};
  }
  const Eigen::LLT<Eigen::MatrixXd> solved(Eigen::MatrixXd::Identity(own.rows(), own.cols()) +
                                           variance * own);
  const double root = solved.matrixLLT().diagonal().prod();
  return {root * root, variance * with_drift.dot(solved.solve(with_drift))};
}

}  // namespace

double log_add(double a, double b) {
  const double max = std::max(a, b);
  return max == -HUGE_VAL ? max : max + std::log1p(std::exp(std::min(a, b) - max));
}

void Sum::add(double log_scale, const Beside& factors) {
  if (log_scale == -HUGE_VAL) return;
  const double ratio = std::exp(-std::abs(log_scale - log_scale_));
  const bool is_larger = log_scale > log_scale_;
  const double own = is_larger ? ratio : 1;
  const double others = is_larger ? 1 : ratio;
  for (std::size_t with = 0; with < factors_.size(); ++with) {
    factors_[with] = own * factors_[with] + others * factors[with];
  }
  log_scale_ = std::max(log_scale_, log_scale);
}

Likelihood::Likelihood(const Rivals& rivals) : freedom_(rivals.freedom()) {
  const double most = std::max(kLargest, 3 * rivals.spread());
  for (double size = kSmallest; size < most * kFactorOfSize; size *= kFactorOfSize) {
    sizes_.push_back(size);
  }
  smooth_sizes_.push_back(0);
  for (std::size_t i = 1; i < sizes_.size(); i += 2) smooth_sizes_.push_back(sizes_[i]);
  something_else_ = kSomethingElse / static_cast<double>(smooth_sizes_.size() - 1);
}

Beside Likelihood::prior(std::size_t smooth, double largest) const {
  std::size_t of_errors = 0;
  const double error = kInexact * largest;
  for (std::size_t i = 1; i < smooth_sizes_.size() && error >= kSmallest; ++i) {
    if (i == 1 || smooth_sizes_[i] <= error * kFactorOfSize) of_errors = i;
  }
  return {smooth == of_errors ? 1 - kSomethingElse : 0, smooth > 0 ? something_else_ : 0};
}

double Likelihood::operator()(double log_density, double left) const {
  constexpr double kRounding = 1e-12;  // that an exact model leaves, of a row's noise
  return log_density - freedom_ / 2 * std::log(std::max(left, kRounding * freedom_));
}

double Likelihood::left_for(double log_density, double log_likelihood) const {
  return std::exp(2 * (log_density - log_likelihood) / freedom_);
}

std::vector<Beside> Likelihood::priors_of_sizes(std::size_t smooth, double largest) const {
  const auto count = static_cast<double>(sizes_.size());
  std::vector<Beside> priors;
  for (const double size : sizes_) {
    const Beside beside = prior(smooth, std::max(size, largest));
    priors.push_back({beside[0] / count, beside[1] / count});
  }
  return priors;
}

void Likelihood::add_average(const std::vector<Beside>& priors, double log_density, double left,
                             const Eigen::Ref<const Eigen::MatrixXd>& own,
                             const Eigen::Ref<const Eigen::VectorXd>& with_drift, Sum& sum) const {
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    if (!(priors[i][0] + priors[i][1] > 0)) continue;
    const double variance = sizes_[i] * sizes_[i] / static_cast<double>(own.cols());
    const auto [determinant, square] = added(own, with_drift, variance);
    const double density = 1 / std::sqrt(determinant);
    sum.add((*this)(log_density, left - square), {density * priors[i][0], density * priors[i][1]});
  }
}

}  // namespace fogcomp::judge
