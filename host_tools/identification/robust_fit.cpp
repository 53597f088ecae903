#include "identification/robust_fit.hpp"

#include <algorithm>
#include <cmath>

#include "identification/quiet_rows.hpp"
#include "identification/whitening.hpp"
#include "support/input_error.hpp"
#include "support/median.hpp"
#include "support/text.hpp"

namespace fogcomp {
namespace {

constexpr int kRounds = 3;      // of noise, outlier weights and solution
constexpr double kOutlier = 4;  // standard deviations

Eigen::MatrixXd all_columns(const SignalSeries& series, const std::vector<EffectTerm>& terms,
                            const Eigen::MatrixXd& nuisance) {
  std::vector<Eigen::MatrixXd> parts;
  Eigen::Index width = 0;
  for (const EffectTerm& term : terms) parts.push_back(series.regressors(term));
  parts.push_back(nuisance);
  for (const Eigen::MatrixXd& part : parts) width += part.cols();
  Eigen::MatrixXd all(series.rows().size(), width);
  Eigen::Index at = 0;
  for (const Eigen::MatrixXd& part : parts) {
    all.middleCols(at, part.cols()) = part;
    at += part.cols();
  }
  return all;
}

// Rows that are left out have the value of the nearest row before them that is not.
Eigen::VectorXd bridged(const Eigen::VectorXd& residual, const Eigen::VectorXd& kept) {
  Eigen::VectorXd values = residual;
  for (Eigen::Index row = 1; row < values.size(); ++row) {
    if (kept[row] <= 0) values[row] = values[row - 1];
  }
  return values;
}

NoiseModel noise_of(const Rows& rows, const Eigen::VectorXd& residual) {
  const std::vector<Eigen::VectorXd> quiet = quiet_stretches(rows, residual);
  return quiet.empty() ? white_noise_of(residual, rows.row_s) : fit_noise(quiet, rows.row_s);
}

// Rows that stand out from the others count less the further out they are. "Others" by the median,
// so that where the model itself does not fit, its misfit is no outlier.
Eigen::VectorXd outlier_weights(const Eigen::VectorXd& whitened_residual) {
  const double typical = sigma_by_median({whitened_residual.begin(), whitened_residual.end()});
  const double most = kOutlier * std::max(1.0, typical);
  return whitened_residual.unaryExpr([most](double e) {
    const double beyond = std::abs(e) / most;
    return beyond <= 1 ? 1.0 : 1 / (beyond * beyond);
  });
}

void check_size(const Rows& rows, Eigen::Index unknowns) {
  if (rows.size() > unknowns) return;
  throw InputError("fit", format("%td rows of %g s are too few for %td unknowns; use a longer "
                                 "recording, fewer effects or a shorter --average",
                                 rows.size(), rows.row_s, unknowns));
}

void check_rank(const LinearFit& fit, Eigen::Index columns) {
  if (fit.rank == columns) return;
  throw InputError("fit", format("these recordings determine only %td of %td coefficients; leave "
                                 "out an effect or lower an order",
                                 fit.rank, columns));
}

}  // namespace

double RobustFit::misfit() const {
  const auto freedom = static_cast<double>(residual_dph.size() - fit.covariance.cols());
  return std::sqrt(fit.residual.squaredNorm() / std::max(1.0, freedom));
}

RobustFit fit_robustly(const SignalSeries& series, const std::vector<EffectTerm>& terms,
                       const Eigen::MatrixXd& nuisance, const Eigen::VectorXd& kept) {
  const Rows& rows = series.rows();
  RobustFit result;
  result.terms = terms;
  result.shapes = shape_parameters(terms);
  result.matrix = all_columns(series, terms, nuisance);
  const Eigen::Index linear = result.linear();
  check_size(rows, linear + static_cast<Eigen::Index>(result.shapes.size()));

  const LinearFit first =
      solve_linear(kept.asDiagonal() * result.matrix, kept.cwiseProduct(rows.drift_dph));
  check_rank(first, linear);
  result.residual_dph = rows.drift_dph - result.matrix * first.coefficients;
  result.robust = kept;
  for (int round = 0; round < kRounds; ++round) {
    result.noise = noise_of(rows, bridged(result.residual_dph, kept));
    const Whitening whitening(result.noise, rows, rows.weights.cwiseProduct(result.robust));
    WhitenedProblem problem(series, whitening, result.terms, nuisance);
    search_shapes(problem, result.shapes);
    result.terms = problem.terms();
    result.matrix = all_columns(series, result.terms, nuisance);
    result.fit = solve_linear(problem.jacobian(result.shapes), problem.measured());
    const LinearFit solved = solve_linear(problem.matrix(), problem.measured());
    check_rank(solved, linear);
    result.fit.coefficients.head(linear) = solved.coefficients;
    result.fit.residual = solved.residual;
    result.residual_dph = rows.drift_dph - result.matrix * solved.coefficients;
    const Whitening plain(result.noise, rows, rows.weights.cwiseProduct(kept));
    result.robust = outlier_weights(plain.apply(result.residual_dph)).cwiseProduct(kept);
  }
  return result;
}

}  // namespace fogcomp
