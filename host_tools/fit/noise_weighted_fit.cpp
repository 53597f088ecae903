#include "fit/noise_weighted_fit.hpp"

#include <algorithm>
#include <cmath>

#include "fit/undetermined.hpp"
#include "noise/input_rate.hpp"
#include "noise/noise_scale.hpp"
#include "noise/outlier_rows.hpp"
#include "noise/quiet_rows.hpp"
#include "noise/whitening.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {
namespace {

constexpr int kRounds = 3;  // iterations of noise and solution

Eigen::MatrixXd all_columns(const KnownRegressors& regressors,
                            const std::vector<model::EffectTerm>& terms,
                            const Eigen::MatrixXd& nuisance) {
  const series::Rows& rows = regressors.series().rows();
  const std::vector<series::ColumnRange> columns = series::columns_of(terms, rows.row_s);
  const Eigen::Index own = columns.empty() ? 0 : columns.back().first + columns.back().count;
  Eigen::MatrixXd all(rows.size(), own + nuisance.cols());
  for (std::size_t i = 0; i < terms.size(); ++i) {
    all.middleCols(columns[i].first, columns[i].count) = *regressors(terms[i]);
  }
  all.rightCols(nuisance.cols()) = nuisance;
  return all;
}

Eigen::MatrixXd shape_columns(const WhitenedProblem& problem, const NoiseWeightedFit& fit,
                              double row_s) {
  const std::vector<series::ColumnRange> columns = series::columns_of(fit.terms, row_s);
  Eigen::MatrixXd all(fit.columns.rows(), static_cast<Eigen::Index>(fit.shapes.size()));
  for (std::size_t i = 0; i < fit.shapes.size(); ++i) {
    const series::ColumnRange& range = columns[fit.shapes[i].term];
    all.col(static_cast<Eigen::Index>(i)) =
        problem.derivative(fit.shapes[i], fit.coefficients.segment(range.first, range.count));
  }
  return all;
}

// Relative to the quiet rows, for which the noise model is. Without quiet rows the scale is 1:
// differences between parts may be drift as well as noise.
Eigen::VectorXd relative_scale(const std::vector<recording::RowRange>& quiet,
                               const Eigen::VectorXd& scale) {
  double square = 0;
  double count = 0;
  for (const Eigen::VectorXd& stretch : noise::parts_of(scale, quiet)) {
    square += stretch.squaredNorm();
    count += static_cast<double>(stretch.size());
  }
  if (count == 0) return Eigen::VectorXd::Ones(scale.size());
  return scale / std::sqrt(square / count);
}

// Estimates the noise from the current residual, unless it is given. The part proportional to the
// input rate is excluded: on a rate table it is most of an incomplete model's residual.
void set_noise(const series::Rows& rows, const std::vector<recording::RowRange>& quiet,
               const std::optional<noise::NoiseModel>& known, NoiseWeightedFit& fit) {
  const Eigen::VectorXd left = noise::without_input_rate(rows, fit.residual_dph, fit.robust);
  fit.noise = known ? *known : noise::noise_of(rows, noise::bridged(rows, left, fit.robust));
  fit.noise.white_variance = std::max(std::pow(rows.rounding_dph, 2), fit.noise.white_variance);
  fit.noise_scale = relative_scale(quiet, noise::noise_scale(rows, left, fit.robust));
  fit.row_weights = fit.weights_of(rows, fit.robust);
}

// A range is not searched again for a slightly better noise estimate if nothing was found in it.
// Shapes that no fit has found before were searched in the first round while others had not been
// found yet: once more, of two only the first.
std::vector<bool> ranges_to_search_again(const std::vector<model::EffectTerm>& terms,
                                         const std::vector<model::ShapeParameter>& shapes,
                                         std::vector<bool> elsewhere, int round) {
  if (shapes.size() == 1) return {false};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const bool is_new = terms[shapes[i].term].coefficients_dph.empty();
    if (is_new && round == 0) elsewhere[i] = shapes.size() > 2 || i == 0;
  }
  return elsewhere;
}

// Before the noise is known.
Eigen::VectorXd residual_in_white_noise(const series::Rows& rows, const NoiseWeightedFit& fit) {
  const LinearFit first =
      solve_linear(fit.robust.asDiagonal() * fit.columns, fit.robust.cwiseProduct(rows.drift_dph));
  return rows.drift_dph - fit.columns * first.coefficients;
}

}  // namespace

Eigen::VectorXd NoiseWeightedFit::weights_of(const series::Rows& rows,
                                             const Eigen::VectorXd& kept) const {
  return rows.weights.cwiseProduct(kept).cwiseQuotient(noise_scale.cwiseAbs2());
}

double NoiseWeightedFit::birge_ratio() const {
  const auto degrees_of_freedom = static_cast<double>(
      (row_weights.array() > 0).count() + whitened.rows() - row_weights.size() - whitened.cols());
  return std::sqrt(whitened_residual.squaredNorm() / std::max(1.0, degrees_of_freedom));
}

NoiseWeightedFit fit_rows(const KnownRegressors& known, const std::vector<model::EffectTerm>& terms,
                          const Eigen::MatrixXd& nuisance, const RowSettings& settings) {
  const series::Rows& rows = known.series().rows();
  const Eigen::VectorXd kept =
      settings.kept.size() > 0 ? settings.kept : Eigen::VectorXd::Ones(rows.size());
  const Eigen::VectorXd counted = noise::counted_rows(rows);
  const std::vector<recording::RowRange> quiet = noise::quiet_ranges(rows);
  NoiseWeightedFit fit;
  fit.robust = kept.cwiseProduct(counted);
  fit.outliers = static_cast<std::size_t>((counted.array() <= 0 && kept.array() > 0).count());
  fit.row_weights = rows.weights.cwiseProduct(fit.robust);
  fit.terms = terms;
  fit.shapes = model::shape_parameters(terms);
  if (settings.prior != nullptr) fit.prior = *settings.prior;
  fit.columns = all_columns(known, terms, nuisance);
  fit.residual_dph = residual_in_white_noise(rows, fit);
  std::vector<bool> ranges(fit.shapes.size(), !settings.shapes_found && !fit.prior);
  for (int round = 0; round < kRounds; ++round) {
    set_noise(rows, quiet, settings.noise, fit);
    const noise::Whitening whitening(fit.noise, rows, fit.row_weights);
    WhitenedProblem problem(known, whitening, fit.terms, nuisance, settings.prior);
    const auto progress = [&](double done) {
      if (settings.progress) settings.progress((round + done) / kRounds);
    };
    const bool last = round + 1 == kRounds;
    ranges = ranges_to_search_again(
        terms, fit.shapes, search_shapes(problem, fit.shapes, ranges, last, progress), round);
    fit.terms = problem.terms();
    const LinearFit solved = problem.solve();
    fit.coefficients = solved.coefficients;
    fit.whitened = problem.jacobian(fit.shapes);
    fit.whitened_measured = problem.measured();
    fit.whitened_residual = solved.residual;
    if (!fit.shapes.empty()) fit.columns = all_columns(known, fit.terms, nuisance);
    if (last) {
      fit.covariance = problem.solve(fit.shapes).covariance;
      fit.shape_columns = shape_columns(problem, fit, rows.row_s);
    }
    fit.residual_dph = rows.drift_dph - fit.columns * fit.coefficients;
  }
  return fit;
}

NoiseWeightedFit fit_determined(const KnownRegressors& known,
                                const std::vector<model::EffectTerm>& terms,
                                const Eigen::MatrixXd& nuisance, const RowSettings& settings) {
  const series::Rows& rows = known.series().rows();
  NoiseWeightedFit fit = fit_rows(known, terms, nuisance, settings);
  const Eigen::Index unknowns = fit.linear() + static_cast<Eigen::Index>(fit.shapes.size());
  if (rows.size() <= unknowns) {
    throw InputError(
        "fit", format("%s of %g s: too few for %s; use a longer "
                      "recording, fewer effects or a shorter --average",
                      counted(static_cast<std::size_t>(rows.size()), "row").c_str(), rows.row_s,
                      counted(static_cast<std::size_t>(unknowns), "unknown").c_str()));
  }
  if (!is_determined(fit)) refuse_undetermined(fit, rows);
  return fit;
}

Eigen::VectorXd ones_in(const series::Rows& rows, const recording::RowRange& range) {
  Eigen::VectorXd column = Eigen::VectorXd::Zero(rows.size());
  series::of_rows(column, range).setOnes();
  return column;
}

Eigen::VectorXd step_column(const series::Rows& rows, std::size_t row) {
  return ones_in(rows, {row, rows.runs()[rows.run_at(row)].end});
}

bool has_own_biases(const series::Rows& rows, bool wanted) {
  return wanted || !rows.cut_rows.empty();
}

Eigen::MatrixXd run_offset_columns(const series::Rows& rows, bool wanted) {
  const std::vector<recording::RowRange> biases = rows.bias_ranges();
  const std::size_t count = has_own_biases(rows, wanted) ? biases.size() : 1;
  Eigen::MatrixXd columns(rows.size(), static_cast<Eigen::Index>(count) - 1);
  for (std::size_t i = 1; i < count; ++i) {
    columns.col(static_cast<Eigen::Index>(i) - 1) = ones_in(rows, biases[i]);
  }
  return columns;
}

}  // namespace fogcomp::fit
