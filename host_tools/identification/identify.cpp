#include "identification/identify.hpp"

#include <algorithm>
#include <cmath>

#include "identification/least_squares.hpp"
#include "identification/quiet_rows.hpp"
#include "identification/shape_search.hpp"
#include "identification/whitening.hpp"
#include "model/catalogue.hpp"
#include "support/input_error.hpp"
#include "support/median.hpp"
#include "support/text.hpp"

namespace fogcomp {
namespace {

// Beyond the coldest and warmest training row, so that sensor noise at the end of a range is not
// yet outside it.
constexpr double kRangeMarginDegc = 1;
constexpr int kRounds = 3;          // of noise, outlier weights and solution
constexpr double kOutlier = 4;      // standard deviations
constexpr double kConfused = 0.95;  // correlation of two effects' coefficients worth a sentence
constexpr double kVisible = 5;      // standard deviations

Eigen::MatrixXd all_regressors(const SignalSeries& series, const std::vector<EffectTerm>& terms) {
  std::vector<Eigen::MatrixXd> parts;
  Eigen::Index width = 0;
  for (const EffectTerm& term : terms) {
    parts.push_back(series.regressors(term));
    width += parts.back().cols();
  }
  Eigen::MatrixXd all(series.rows().size(), width);
  Eigen::Index at = 0;
  for (const Eigen::MatrixXd& part : parts) {
    all.middleCols(at, part.cols()) = part;
    at += part.cols();
  }
  return all;
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

// Columns of each term within the matrix of all.
struct Columns {
  Eigen::Index first = 0;
  Eigen::Index count = 0;
};
std::vector<Columns> columns_of(const SignalSeries& series, const std::vector<EffectTerm>& terms) {
  std::vector<Columns> columns;
  Eigen::Index first = 0;
  for (const EffectTerm& term : terms) {
    const Eigen::Index count = series.regressors(term).cols();
    columns.push_back({first, count});
    first += count;
  }
  return columns;
}

// Largest correlation between any coefficient of one effect and any of the other.
double correlation(const Eigen::MatrixXd& covariance, const Columns& a, const Columns& b) {
  double largest = 0;
  for (Eigen::Index i = a.first; i < a.first + a.count; ++i) {
    for (Eigen::Index j = b.first; j < b.first + b.count; ++j) {
      largest = std::max(
          largest, std::abs(covariance(i, j)) / std::sqrt(covariance(i, i) * covariance(j, j)));
    }
  }
  return largest;
}

std::vector<std::string> confusions(const std::vector<EffectTerm>& terms,
                                    const std::vector<Columns>& columns,
                                    const Eigen::MatrixXd& covariance) {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    for (std::size_t j = i + 1; j < terms.size(); ++j) {
      const double rho = correlation(covariance, columns[i], columns[j]);
      if (rho < kConfused) continue;
      warnings.push_back(
          format("`%s` and `%s` are %.2f correlated on these data: their sum is known, "
                 "their split is not",
                 terms[i].name.c_str(), terms[j].name.c_str(), rho));
    }
  }
  return warnings;
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

template <class Value>
Range range_of(std::size_t count, Value value_at) {
  Range range{value_at(0), value_at(0)};
  for (std::size_t i = 1; i < count; ++i) {
    range.least = std::min(range.least, value_at(i));
    range.most = std::max(range.most, value_at(i));
  }
  return range;
}

void set_ranges(Model& model, const Rows& rows) {
  const std::size_t count = rows.signals.size();
  const Range degc = range_of(count, [&](std::size_t i) { return rows.signals[i].temperature; });
  model.least_degc = degc.least - kRangeMarginDegc;
  model.most_degc = degc.most + kRangeMarginDegc;
  model.rate_range_degc_per_min =
      range_of(count, [&](std::size_t i) { return rows.signals[i].temperature_rate; });
  model.time_range_s = range_of(count, [&](std::size_t i) { return rows.time_s[i]; });
}

}  // namespace

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

Identification identify(Model& model, const SignalSeries& series,
                        const IdentifySettings& settings) {
  const Rows& rows = series.rows();
  const std::vector<ShapeParameter> shapes = shape_parameters(model.terms);
  const std::vector<Columns> columns = columns_of(series, model.terms);
  const Eigen::MatrixXd offsets = run_offset_columns(rows, settings.run_offsets);
  const Eigen::Index coefficients = columns.back().first + columns.back().count;
  const Eigen::Index linear = coefficients + offsets.cols();
  check_size(rows, linear + static_cast<Eigen::Index>(shapes.size()));

  const auto all_columns = [&] {
    Eigen::MatrixXd all(rows.size(), linear);
    all << all_regressors(series, model.terms), offsets;
    return all;
  };
  const LinearFit first = solve_linear(all_columns(), rows.drift_dph);
  check_rank(first, linear);

  Identification result;
  result.residual_dph = first.residual;
  Eigen::VectorXd robust = Eigen::VectorXd::Ones(rows.size());
  LinearFit fit;
  for (int round = 0; round < kRounds; ++round) {
    result.noise = noise_of(rows, result.residual_dph);
    const Whitening whitening(result.noise, rows, rows.weights.cwiseProduct(robust));
    WhitenedProblem problem(series, whitening, model.terms, offsets);
    search_shapes(problem, shapes);
    model.terms = problem.terms();
    fit = solve_linear(problem.jacobian(shapes), problem.measured());
    const LinearFit solved = solve_linear(problem.matrix(), problem.measured());
    check_rank(solved, linear);
    fit.coefficients.head(linear) = solved.coefficients;
    fit.residual = solved.residual;
    result.residual_dph = rows.drift_dph - all_columns() * solved.coefficients;
    const Whitening plain(result.noise, rows, rows.weights);
    robust = outlier_weights(plain.apply(result.residual_dph));
  }

  result.row_weights = rows.weights.cwiseProduct(robust);
  const auto freedom = static_cast<double>(rows.size() - fit.covariance.cols());
  result.misfit = std::sqrt(fit.residual.squaredNorm() / std::max(1.0, freedom));
  result.outliers = static_cast<std::size_t>((robust.array() < 1).count());
  const Eigen::VectorXd sigma =
      fit.covariance.diagonal().cwiseSqrt() * std::max(1.0, result.misfit);
  const auto offset_values = fit.coefficients.segment(coefficients, offsets.cols());
  result.run_offsets_dph.assign(offset_values.begin(), offset_values.end());
  const Eigen::MatrixXd matrix = all_regressors(series, model.terms);
  for (std::size_t i = 0; i < model.terms.size(); ++i) {
    EffectTerm& term = model.terms[i];
    const auto values = fit.coefficients.segment(columns[i].first, columns[i].count);
    const auto sigmas = sigma.segment(columns[i].first, columns[i].count);
    term.coefficients_dph.assign(values.begin(), values.end());
    term.sigma_dph.assign(sigmas.begin(), sigmas.end());
    const Eigen::MatrixXd part = matrix.middleCols(columns[i].first, columns[i].count);
    const Eigen::MatrixXd covariance = fit.covariance.block(columns[i].first, columns[i].first,
                                                            columns[i].count, columns[i].count);
    const double largest_variance =
        (part * covariance).cwiseProduct(part).rowwise().sum().maxCoeff();
    result.visible_dph.push_back(kVisible * std::max(1.0, result.misfit) *
                                 std::sqrt(largest_variance));
  }
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    EffectTerm& term = model.terms[shapes[i].term];
    term.parameter_sigma[shapes[i].index] = sigma[linear + static_cast<Eigen::Index>(i)] *
                                            shapes[i].slope(term.parameters[shapes[i].index]);
  }
  result.warnings = confusions(model.terms, columns, fit.covariance);
  set_ranges(model, rows);
  model.residual_rms_dph =
      std::sqrt(result.residual_dph.cwiseAbs2().dot(rows.weights) / rows.weights.sum());
  return result;
}

}  // namespace fogcomp
