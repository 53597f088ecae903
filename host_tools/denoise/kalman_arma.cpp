#include "denoise/kalman_arma.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "denoise/decision_rules.hpp"
#include "support/decompositions.hpp"

namespace fogcomp::denoise {
namespace {

using Eigen::Index;
using Eigen::Matrix4d;
using Eigen::MatrixXd;
using Eigen::Vector4d;
using Eigen::VectorXd;

// Variance of the slope's change per row, relative to that of the noise.
constexpr double kMinWander = 1e-12;
constexpr double kMaxWander = 1e-2;
constexpr double kWanderStep = 10;
constexpr double kUnknown = 1e6;  // initial variance, relative to that of the noise

VectorXd without_running_mean(fog::Span<const double> values) {
  const auto size = static_cast<Index>(values.size);
  VectorXd sums(size + 1);
  sums[0] = 0;
  for (Index i = 0; i < size; ++i) sums[i + 1] = sums[i] + values.data[i];
  VectorXd rest(size);
  for (Index i = 0; i < size; ++i) {
    const Index half = std::min({rules::kRunningMean / 2, i, size - 1 - i});
    const double mean = (sums[i + half + 1] - sums[i - half]) / static_cast<double>(2 * half + 1);
    rest[i] = values.data[i] - mean;
  }
  // The mean contains the value itself and thus removes a part of the noise.
  return rest * std::sqrt(1 / (1 - 1.0 / static_cast<double>(rules::kRunningMean)));
}

VectorXd regression(const MatrixXd& columns, const VectorXd& target) {
  MatrixXd normal = gram(columns);
  normal.diagonal().array() += 1e-12 * normal.trace() + 1e-300;
  return solve_semidefinite(normal, columns.transpose() * target);
}

bool stationary(const ArmaNoise& noise) {
  return std::abs(noise.phi2) < 0.999 && noise.phi1 + noise.phi2 < 0.999 &&
         noise.phi2 - noise.phi1 < 0.999 && std::abs(noise.theta) < 0.999;
}

// State: level, slope per row, and the ARMA noise in Harvey's form.
struct Filter {
  Matrix4d transition;
  Matrix4d disturbance;
  Vector4d observed{1, 0, 1, 0};
  Matrix4d first_covariance;
};

// Stationary covariance of the noise's state.
Matrix4d filter_covariance(const Matrix4d& transition, const Matrix4d& disturbance) {
  Matrix4d covariance = disturbance;
  for (int i = 0; i < 2000; ++i) {
    covariance = transition * covariance * transition.transpose() + disturbance;
  }
  return covariance;
}

Filter make_filter(const ArmaNoise& noise, double wander) {
  Filter filter;
  filter.transition << 1, 1, 0, 0,  //
      0, 1, 0, 0,                   //
      0, 0, noise.phi1, 1,          //
      0, 0, noise.phi2, 0;
  const Vector4d to_noise(0, 0, 1, noise.theta);
  filter.disturbance = noise.variance * to_noise * to_noise.transpose();
  Matrix4d arma = filter.transition;
  arma.topLeftCorner<2, 2>().setZero();
  filter.first_covariance = filter_covariance(arma, filter.disturbance);
  filter.first_covariance(0, 0) = kUnknown * noise.variance;
  filter.first_covariance(1, 1) = noise.variance;
  filter.disturbance(1, 1) = wander * noise.variance;
  return filter;
}

struct Step {
  Vector4d predicted, filtered;
  Matrix4d predicted_covariance, filtered_covariance;
};

// -2 log likelihood; stores the steps if `steps` is given.
double run(const Filter& filter, fog::Span<const double> values, std::vector<Step>* steps) {
  Vector4d state(values.data[0], 0, 0, 0);
  Matrix4d covariance = filter.first_covariance;
  double cost = 0;
  for (std::size_t i = 0; i < values.size; ++i) {
    if (i > 0) {
      state = filter.transition * state;
      covariance =
          filter.transition * covariance * filter.transition.transpose() + filter.disturbance;
    }
    const Vector4d cross_covariance = covariance * filter.observed;
    const double variance = filter.observed.dot(cross_covariance);
    const double innovation = values.data[i] - filter.observed.dot(state);
    cost += std::log(variance) + innovation * innovation / variance;
    const Vector4d filtered = state + cross_covariance * (innovation / variance);
    const Matrix4d filtered_covariance =
        covariance - cross_covariance * cross_covariance.transpose() / variance;
    if (steps != nullptr) steps->push_back({state, filtered, covariance, filtered_covariance});
    state = filtered;
    covariance = filtered_covariance;
  }
  return cost;
}

// Smoother of Rauch, Tung and Striebel; writes the levels to `values`.
void smooth(const Filter& filter, const std::vector<Step>& steps, fog::Span<double> values) {
  Vector4d state = steps.back().filtered;
  values.data[values.size - 1] = state[0];
  for (std::size_t i = steps.size() - 1; i-- > 0;) {
    const Matrix4d gain = steps[i + 1]
                              .predicted_covariance.ldlt()
                              .solve(filter.transition * steps[i].filtered_covariance)
                              .transpose();
    state = steps[i].filtered + gain * (state - steps[i + 1].predicted);
    values.data[i] = state[0];
  }
}

}  // namespace

ArmaNoise fit_arma(fog::Span<const double> values) {
  const VectorXd x = without_running_mean(values);
  const double mean_square = x.squaredNorm() / static_cast<double>(std::max<Index>(1, x.size()));
  const ArmaNoise white{0, 0, 0, mean_square};
  if (values.size < rules::kMinValues) return white;
  const Index long_rows = x.size() - rules::kLongOrder;
  MatrixXd columns(long_rows, rules::kLongOrder);
  for (Index k = 0; k < rules::kLongOrder; ++k) {
    columns.col(k) = x.segment(rules::kLongOrder - 1 - k, long_rows);
  }
  const VectorXd e = x.tail(long_rows) - columns * regression(columns, x.tail(long_rows));

  const Index rows = long_rows - 1;
  MatrixXd last(rows, 3);
  last.col(0) = x.segment(rules::kLongOrder, rows);
  last.col(1) = x.segment(rules::kLongOrder - 1, rows);
  last.col(2) = e.head(rows);
  const VectorXd target = x.tail(rows);
  const VectorXd coefficients = regression(last, target);
  const double variance = (target - last * coefficients).squaredNorm() / static_cast<double>(rows);
  const ArmaNoise noise{coefficients[0], coefficients[1], coefficients[2], variance};
  return stationary(noise) ? noise : white;
}

ArmaNoise kalman_smooth(fog::Span<double> values) {
  const fog::Span<const double> read_only{values.data, values.size};
  const ArmaNoise noise = fit_arma(read_only);
  if (!(noise.variance > 0)) return noise;  // no noise to remove
  double min = HUGE_VAL;
  Filter best;
  for (double wander = kMinWander; wander <= kMaxWander; wander *= kWanderStep) {
    const Filter filter = make_filter(noise, wander);
    const double cost = run(filter, read_only, nullptr);
    if (cost >= min) continue;
    min = cost;
    best = filter;
  }
  std::vector<Step> steps;
  steps.reserve(values.size);
  run(best, read_only, &steps);
  smooth(best, steps, values);
  return noise;
}

}  // namespace fogcomp::denoise
