#include "identification/noise_weighted_fit.hpp"

#include <algorithm>
#include <cmath>

#include "identification/quiet_rows.hpp"
#include "identification/whitening.hpp"
#include "support/median.hpp"

namespace fogcomp {
namespace {

constexpr int kRounds = 3;      // of noise, outlier weights and solution
constexpr double kOutlier = 4;  // standard deviations

Eigen::MatrixXd all_columns(const SignalSeries& series, const std::vector<EffectTerm>& terms,
                            const Eigen::MatrixXd& nuisance) {
  std::vector<Eigen::MatrixXd> parts;
  for (const EffectTerm& term : terms) parts.push_back(series.regressors(term));
  parts.push_back(nuisance);
  return side_by_side(parts, series.rows().size());
}

}  // namespace

double longest_run_s(const Rows& rows) {
  double longest_s = 0;
  for (std::size_t run = 0; run < rows.run_starts.size(); ++run) {
    const std::size_t end =
        run + 1 < rows.run_starts.size() ? rows.run_starts[run + 1] : rows.time_s.size();
    longest_s = std::max(longest_s, rows.time_s[end - 1] - rows.time_s[rows.run_starts[run]]);
  }
  return longest_s;
}

NoiseModel noise_of(const Rows& rows, const Eigen::VectorXd& residual) {
  const std::vector<Eigen::VectorXd> quiet = quiet_stretches(rows, residual);
  if (quiet.empty()) return white_noise_of(residual, rows.row_s);
  return fit_noise(noise_samples(quiet), rows.row_s, longest_run_s(rows));
}

namespace {

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

}  // namespace

NoiseWeightedFit fit_rows(const SignalSeries& series, const std::vector<EffectTerm>& terms,
                          const Eigen::MatrixXd& nuisance,
                          const std::optional<NoiseModel>& known_noise) {
  const Rows& rows = series.rows();
  NoiseWeightedFit fit;
  fit.terms = terms;
  fit.shapes = shape_parameters(terms);
  fit.columns = all_columns(series, terms, nuisance);
  fit.residual_dph = solve_linear(fit.columns, rows.drift_dph).residual;
  Eigen::VectorXd robust = Eigen::VectorXd::Ones(rows.size());
  for (int round = 0; round < kRounds; ++round) {
    fit.noise = known_noise ? *known_noise : noise_of(rows, fit.residual_dph);
    fit.row_weights = rows.weights.cwiseProduct(robust);
    const Whitening whitening(fit.noise, rows, fit.row_weights);
    WhitenedProblem problem(series, whitening, fit.terms, nuisance);
    search_shapes(problem, fit.shapes);
    fit.terms = problem.terms();
    const LinearFit solved = solve_linear(problem.matrix(), problem.measured());
    fit.rank = solved.rank;
    fit.coefficients = solved.coefficients;
    fit.whitened = problem.jacobian(fit.shapes);
    fit.whitened_measured = problem.measured();
    fit.whitened_residual = solved.residual;
    if (!fit.shapes.empty()) fit.columns = all_columns(series, fit.terms, nuisance);
    fit.residual_dph = rows.drift_dph - fit.columns * fit.coefficients;
    fit.outliers = static_cast<std::size_t>((robust.array() < 1).count());
    robust = outlier_weights(Whitening(fit.noise, rows, rows.weights).apply(fit.residual_dph));
  }
  fit.covariance = solve_linear(fit.whitened, fit.whitened_measured).covariance;
  return fit;
}

Eigen::MatrixXd run_offset_columns(const Rows& rows, bool wanted) {
  const std::size_t runs = wanted ? rows.run_starts.size() : 1;
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(rows.size(), static_cast<Eigen::Index>(runs) - 1);
  for (std::size_t run = 1; run < runs; ++run) {
    const auto first = static_cast<Eigen::Index>(rows.run_starts[run]);
    const auto end =
        run + 1 < runs ? static_cast<Eigen::Index>(rows.run_starts[run + 1]) : rows.size();
    columns.col(static_cast<Eigen::Index>(run) - 1).segment(first, end - first).setOnes();
  }
  return columns;
}

}  // namespace fogcomp
