#include "fit/turn_on_repeatability.hpp"

#include <algorithm>
#include <cmath>

#include "fit/decision_rules.hpp"
#include "fit/whitened_problem.hpp"
#include "model/shape_parameter.hpp"
#include "noise/whitening.hpp"
#include "support/decompositions.hpp"
#include "support/least_squares.hpp"
#include "support/statistics.hpp"

namespace fogcomp::fit {
namespace {

// Differences between power-ons that the effects cannot make, independent of each other.
struct Differences {
  Eigen::ArrayXd squares;  // of what was measured; expected: noise + gains spread^2
  Eigen::ArrayXd gains;
  double noise = 1;      // variance of each
  Eigen::MatrixXd axes;  // power-ons x differences
};

// All whitened; `effects`: any basis of what they can do; `rows`: number that count.
Differences differences(const Eigen::MatrixXd& effects, const Eigen::MatrixXd& offsets,
                        const Eigen::VectorXd& measured, Eigen::Index rows) {
  const Eigen::MatrixXd basis = orthonormal(effects);
  const Eigen::MatrixXd left = projected_out(basis, offsets);
  Eigen::MatrixXd power_ons(left.rows(), left.cols() + 1);
  power_ons << -left.rowwise().sum(), left;
  const Eigen::VectorXd unexplained = projected_out(basis, measured);
  const SymmetricEigen axes = symmetric_eigen(gram(power_ons));
  const Eigen::ArrayXd along =
      (axes.vectors.transpose() * (power_ons.transpose() * unexplained)).array().square();
  // What the effects imitate but for less than their formulas are good for shows nothing.
  const double none = rules::kModelFormTolerance * offsets.colwise().squaredNorm().maxCoeff();
  const Eigen::Index shown = (axes.values.array() > none).count();  // values ascend
  Differences result{along.tail(shown) / axes.values.tail(shown).array(), axes.values.tail(shown),
                     1, axes.vectors.rightCols(shown)};
  const auto others = static_cast<double>(rows - basis.cols() - shown);
  result.noise =
      std::max(1.0, (unexplained.squaredNorm() - result.squares.sum()) / std::max(1.0, others));
  return result;
}

Eigen::Index count_of(const Eigen::VectorXd& row_weights) {
  return (row_weights.array() > 0).count();
}

// What terms with coefficients leave of the differences, with one bias for all.
Differences left_by(const KnownRegressors& known, const std::vector<model::EffectTerm>& terms,
                    const JudgedWith& with) {
  const series::Rows& rows = known.series().rows();
  const noise::Whitening whitening(with.noise, rows, with.row_weights);
  const WhitenedProblem problem(known, whitening, terms, Eigen::MatrixXd(rows.size(), 0));
  return differences(problem.jacobian(model::shape_parameters(terms)),
                     whitening.apply(run_offset_columns(rows)), problem.measured(),
                     count_of(with.row_weights));
}

// A^-1 B for a symmetric A that may be singular up to rounding: a shape may be known exactly.
Eigen::MatrixXd divided(const Eigen::MatrixXd& b, const Eigen::MatrixXd& a) {
  Eigen::MatrixXd result(b.rows(), b.cols());
  for (Eigen::Index i = 0; i < b.cols(); ++i) result.col(i) = solve_semidefinite(a, b.col(i));
  return result;
}

// What the linear unknowns do with a change of the offsets, shapes held: linear x offsets.
Eigen::MatrixXd gain(double repeatability_dph, const series::ColumnRange& offsets,
                     Eigen::Index linear, const Eigen::MatrixXd& covariance) {
  const Eigen::Index shapes = covariance.rows() - linear;
  Eigen::MatrixXd held = covariance.topLeftCorner(linear, linear);
  if (shapes > 0) {
    const Eigen::MatrixXd with_shapes = covariance.topRightCorner(linear, shapes);
    held -= with_shapes *
            divided(with_shapes.transpose(), covariance.bottomRightCorner(shapes, shapes));
  }
  const Eigen::MatrixXd with_offsets = held.middleCols(offsets.first, offsets.count);
  const Eigen::MatrixXd expected =
      with_offsets.middleRows(offsets.first, offsets.count) +
      repeatability_dph * repeatability_dph * covariance_of_offsets(offsets.count);
  return divided(with_offsets.transpose(), expected).transpose();
}

// For any gain: Joseph's form. The bias becomes the model's.
Eigen::MatrixXd covariance_after(const Eigen::MatrixXd& before, const Eigen::MatrixXd& gain,
                                 double spread_square, const BiasColumns& columns) {
  const auto& [bias, offsets, shares] = columns;
  Eigen::MatrixXd change = Eigen::MatrixXd::Identity(before.rows(), before.cols());
  change.block(0, offsets.first, gain.rows(), offsets.count) -= gain;
  Eigen::MatrixXd of_spread = Eigen::MatrixXd::Zero(before.rows(), offsets.count);
  of_spread.topRows(gain.rows()) = gain;
  Eigen::MatrixXd mean = Eigen::MatrixXd::Identity(before.rows(), before.cols());
  if (bias) {
    mean.row(*bias).segment(offsets.first, offsets.count) = shares.tail(offsets.count).transpose();
  }
  return mean *
         (change * before * change.transpose() + spread_square * of_spread *
                                                     covariance_of_offsets(offsets.count) *
                                                     of_spread.transpose()) *
         mean.transpose();
}

}  // namespace

Eigen::MatrixXd covariance_of_offsets(Eigen::Index offsets) {
  return Eigen::MatrixXd::Identity(offsets, offsets) + Eigen::MatrixXd::Ones(offsets, offsets);
}

TurnOnRepeatability turn_on_repeatability(const NoiseWeightedFit& fit,
                                          const series::ColumnRange& offsets,
                                          const Eigen::MatrixXd& covariance) {
  constexpr int kSteps = 1000;  // over all variances that can be told from 0, about 2 % each
  const Eigen::Index end = offsets.first + offsets.count;
  const Eigen::MatrixXd effects = side_by_side(
      {fit.whitened.leftCols(offsets.first), fit.whitened.rightCols(fit.whitened.cols() - end)},
      fit.whitened.rows());
  const Differences seen =
      differences(effects, fit.whitened.middleCols(offsets.first, offsets.count),
                  fit.whitened_measured, count_of(fit.row_weights));
  if (seen.gains.size() == 0) return {};
  Eigen::ArrayXd noise = Eigen::ArrayXd::Constant(seen.gains.size(), seen.noise);
  if (covariance.size() > 0) {
    const auto own = covariance.block(offsets.first, offsets.first, offsets.count, offsets.count);
    const auto axes = seen.axes.bottomRows(offsets.count);
    noise =
        noise.max(seen.gains * (own * axes).cwiseProduct(axes).colwise().sum().transpose().array());
  }
  const auto log_likelihood = [&](double variance) {
    const Eigen::ArrayXd expected = noise + seen.gains * variance;
    return -(expected.log() + seen.squares / expected).sum() / 2;
  };
  const double max = (seen.squares / seen.gains).maxCoeff();
  const double of_one_bias = log_likelihood(0);
  double best = 0;
  double best_log = of_one_bias;
  for (int step = 0; step < kSteps; ++step) {
    const double variance = max * std::pow(1e-8, static_cast<double>(step) / kSteps);
    const double log = log_likelihood(variance);
    if (log <= best_log) continue;
    best = variance;
    best_log = log;
  }
  if (best == 0) return {};
  return {std::sqrt(best), std::erfc(std::sqrt(best_log - of_one_bias)) / 2};
}

double chance_of_biases(const KnownRegressors& known, const std::vector<model::EffectTerm>& before,
                        const std::vector<model::EffectTerm>& after, const JudgedWith& with) {
  constexpr double kTries = 24;  // of a shape: what shape_search tries of most
  const Differences without = left_by(known, before, with);
  const Differences left = left_by(known, after, with);
  const auto taken = static_cast<double>(without.squares.size() - left.squares.size());
  const auto remaining = static_cast<double>(left.squares.size());
  if (taken <= 0) return 0;
  if (remaining == 0) return 1;
  const double variance = std::max(left.squares.sum() / remaining, left.noise);
  const double ratio = (without.squares.sum() - left.squares.sum()) / taken / variance;
  const auto shapes = static_cast<double>(model::shape_parameters(after).size()) -
                      static_cast<double>(model::shape_parameters(before).size());
  return std::min(1.0, std::pow(kTries, std::max(0.0, shapes)) *
                           chance_of_variance_ratio(std::max(0.0, ratio), taken, remaining));
}

void expect_repeatability(double repeatability_dph, const BiasColumns& columns,
                          NoiseWeightedFit& fit, Eigen::MatrixXd& covariance) {
  const series::ColumnRange& offsets = columns.offsets;
  const Eigen::MatrixXd gains = gain(repeatability_dph, offsets, fit.linear(), covariance);
  const Eigen::VectorXd change = gains * fit.coefficients.segment(offsets.first, offsets.count);
  fit.coefficients -= change;
  fit.residual_dph += fit.columns * change;
  fit.whitened_residual += fit.whitened.leftCols(fit.linear()) * change;
  const double spread_square = repeatability_dph * repeatability_dph;
  covariance = covariance_after(covariance, gains, spread_square, columns);
  if (columns.bias) {
    covariance(*columns.bias, *columns.bias) += spread_square * columns.shares.squaredNorm();
  }
  // This one is for noise as expected: what differs from it is in the misfit.
  const double unit = std::pow(std::max(1.0, fit.birge_ratio()), 2);
  fit.covariance = covariance_after(fit.covariance, gains, spread_square / unit, columns);
}

}  // namespace fogcomp::fit
