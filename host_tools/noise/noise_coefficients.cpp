#include "noise/noise_coefficients.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "noise/allan_model.hpp"
#include "noise/decision_rules.hpp"
#include "support/decompositions.hpp"
#include "support/units.hpp"

namespace fogcomp::noise {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Points {
  VectorXd variance;            // sigma^2, (deg/h)^2
  VectorXd degrees_of_freedom;  // of each, the model's error included
};

Points points_of(const std::vector<AllanPoint>& allan) {
  Points points;
  const auto count = static_cast<Index>(allan.size());
  points.variance.resize(count);
  points.degrees_of_freedom.resize(count);
  for (Index k = 0; k < count; ++k) {
    const AllanPoint& point = allan[static_cast<std::size_t>(k)];
    points.variance[k] = point.sigma * point.sigma;
    points.degrees_of_freedom[k] =
        1 / (1 / point.pairs + rules::kAllanModelError * rules::kAllanModelError / 2);
  }
  return points;
}

struct Fit {
  VectorXd squares;         // of the coefficients, all terms
  VectorXd standard_error;  // of the squares
  double score = 0;         // -2 ln likelihood + 2 * effective number of terms; lower is better
  double inflation = 1;     // of score differences, because the points are correlated
};

// Weighted least-squares solution for the points' variances.
struct Solution {
  VectorXd squares;  // of the coefficients
  VectorXd modelled;
  VectorXd weight;
  MatrixXd inverse;  // of the normal matrix
};

// Treats the points as independent and chi-square distributed about the model, which gives the
// weights of the next iteration.
std::optional<Solution> solve(const MatrixXd& design, const Points& points) {
  constexpr int kRounds = 30;
  Solution s;
  s.modelled = points.variance;
  for (int round = 0; round < kRounds; ++round) {
    s.weight = points.degrees_of_freedom.array() / (2 * s.modelled.array().square());
    s.inverse = inverse_of_definite(gram(s.weight.cwiseSqrt().asDiagonal() * design));
    s.squares = s.inverse * (design.transpose() * s.weight.cwiseProduct(points.variance));
    if (!s.squares.allFinite()) return std::nullopt;
    // Kept positive, because they are weights of the next iteration.
    s.modelled = design * s.squares.cwiseMax(1e-3 * s.inverse.diagonal().cwiseSqrt());
  }
  if ((s.squares.array() <= 0).any()) return std::nullopt;
  return s;
}

/// Most probable non-negative coefficients of the terms `set`, with points treated as independent
/// and chi-square distributed about the model. Errors and the penalty for terms then use the true
/// covariance of the points (composite likelihood: Godambe's "sandwich", criterion of Varin and
/// Vidoni). Weights from that covariance would be optimal in theory, but follow its smallest
/// eigenvalues where the spectrum differs from the model. Nothing if the terms cannot all be
/// positive.
std::optional<Fit> fit_terms(const AllanModel& model, const Points& points,
                             const std::vector<Index>& set) {
  const auto count = static_cast<Index>(set.size());
  if (count > points.variance.size()) return std::nullopt;
  MatrixXd design(points.variance.size(), count);
  for (Index j = 0; j < count; ++j) {
    design.col(j) = model.terms().col(set[static_cast<std::size_t>(j)]);
  }
  const std::optional<Solution> solution = solve(design, points);
  if (!solution) return std::nullopt;
  const auto& [squares, modelled, weight, inverse] = *solution;

  Fit fit;
  fit.squares = VectorXd::Zero(AllanModel::kTerms);
  fit.standard_error = VectorXd::Zero(AllanModel::kTerms);
  for (Index j = 0; j < count; ++j) fit.squares[set[static_cast<std::size_t>(j)]] = squares[j];

  MatrixXd covariance = model.covariance(fit.squares);
  covariance.diagonal() += rules::kAllanModelError * rules::kAllanModelError * modelled.cwiseAbs2();
  const MatrixXd weighted = weight.asDiagonal() * design;
  const MatrixXd variability = weighted.transpose() * covariance * weighted;
  const MatrixXd sandwich = inverse * variability * inverse;
  for (Index j = 0; j < count; ++j) {
    fit.standard_error[set[static_cast<std::size_t>(j)]] = std::sqrt(sandwich(j, j));
  }
  const double effective_terms = (inverse * variability).trace();
  fit.inflation = effective_terms / static_cast<double>(count);
  const VectorXd deviance = modelled.array().log() + points.variance.array() / modelled.array();
  fit.score = points.degrees_of_freedom.dot(deviance) + 2 * effective_terms;
  return fit;
}

/// Fits that the data do not exclude, best first.
std::vector<Fit> plausible_fits(const AllanModel& model, const Points& points) {
  constexpr unsigned kSets = 1U << AllanModel::kTerms;
  std::vector<Fit> fits;
  for (unsigned chosen = 1; chosen < kSets; ++chosen) {
    std::vector<Index> set;
    for (Index term = 0; term < AllanModel::kTerms; ++term) {
      if ((chosen >> term & 1U) != 0U) set.push_back(term);
    }
    if (auto fit = fit_terms(model, points, set)) fits.push_back(std::move(*fit));
  }
  if (fits.empty()) return fits;
  std::sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.score < b.score; });
  const double worst = fits.front().score + rules::kPlausibleScore * fits.front().inflation;
  fits.erase(
      std::find_if(fits.begin(), fits.end(), [&](const Fit& fit) { return fit.score > worst; }),
      fits.end());
  return fits;
}

/// The value of the best fit, with an interval that covers those of all fits.
std::optional<NoiseCoefficient> consensus(const std::vector<Fit>& fits, AllanModel::Term term) {
  if (fits.empty()) return std::nullopt;
  NoiseCoefficient result{std::sqrt(fits.front().squares[term]), 0};
  for (const Fit& fit : fits) {
    if (!(fit.squares[term] > 0)) return std::nullopt;
    const double value = std::sqrt(fit.squares[term]);
    // two standard errors; d sqrt(c) = dc / (2 sqrt(c))
    const double half_width = fit.standard_error[term] / value;
    result.half_width_95 =
        std::max(result.half_width_95, std::fabs(value - result.value) + half_width);
  }
  return result;
}

}  // namespace

NoiseCoefficients fit_noise_coefficients(const std::vector<AllanPoint>& allan) {
  const bool all_positive = std::all_of(allan.begin(), allan.end(),
                                        [](const AllanPoint& point) { return point.sigma > 0; });
  if (allan.empty() || !all_positive) return {};
  const std::vector<Fit> fits = plausible_fits(AllanModel(allan), points_of(allan));
  return {consensus(fits, AllanModel::kQuantization), consensus(fits, AllanModel::kAngleWalk),
          consensus(fits, AllanModel::kInstability), consensus(fits, AllanModel::kRateWalk),
          consensus(fits, AllanModel::kRamp)};
}

double sigma_of_term(Eigen::Index term, double coefficient, double tau_s) {
  return coefficient * std::sqrt(AllanModel::variance_of_terms(tau_s / kSecondsPerHour)[term]);
}

double instability_bound_dph(const std::vector<AllanPoint>& allan) {
  constexpr double kInstabilityToFloor = 0.664;  // sqrt(2 ln 2 / pi)
  const auto lowest =
      std::min_element(allan.begin(), allan.end(), [](const AllanPoint& a, const AllanPoint& b) {
        return a.sigma + a.one_sigma < b.sigma + b.one_sigma;
      });
  return (lowest->sigma + 2 * lowest->one_sigma) / kInstabilityToFloor;
}

}  // namespace fogcomp::noise
