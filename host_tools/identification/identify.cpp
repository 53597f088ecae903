#include "identification/identify.hpp"

#include <algorithm>
#include <cmath>

#include "identification/noise_weighted_fit.hpp"
#include "model/catalogue.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp {
namespace {

// Beyond the coldest and warmest training row, so that sensor noise at the end of a range is not
// yet outside it.
constexpr double kRangeMarginDegc = 1;
constexpr double kConfused = 0.95;  // correlation of two effects' coefficients worth a sentence
constexpr double kVisible = 5;      // standard deviations

// Columns of each term within the matrix of all.
struct Columns {
  Eigen::Index first = 0;
  Eigen::Index count = 0;
};
std::vector<Columns> columns_of(const std::vector<EffectTerm>& terms, double block_s) {
  std::vector<Columns> columns;
  Eigen::Index first = 0;
  for (const EffectTerm& term : terms) {
    const CatalogueEntry& entry = find_effect(term.name);
    const auto effect = entry.make(entry.constants(term.parameters, block_s));
    const auto count = static_cast<Eigen::Index>(effect->regressor_count());
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

void check_rank(const NoiseWeightedFit& fit) {
  if (fit.rank == fit.linear()) return;
  throw InputError("fit", format("these recordings determine only %td of %td coefficients; leave "
                                 "out an effect or lower an order",
                                 fit.rank, fit.linear()));
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

Identification identify(Model& model, const SignalSeries& series,
                        const IdentifySettings& settings) {
  const Rows& rows = series.rows();
  const std::vector<Columns> columns = columns_of(model.terms, rows.row_s);
  const Eigen::MatrixXd offsets = run_offset_columns(rows, settings.run_offsets);
  const Eigen::Index coefficients = columns.back().first + columns.back().count;
  const Eigen::Index linear = coefficients + offsets.cols();
  const auto shapes = static_cast<Eigen::Index>(shape_parameters(model.terms).size());
  check_size(rows, linear + shapes);

  const NoiseWeightedFit fit = fit_rows(series, model.terms, offsets);
  check_rank(fit);
  model.terms = fit.terms;
  Identification result;
  result.residual_dph = fit.residual_dph;
  result.noise = fit.noise;
  result.row_weights = fit.row_weights;
  const auto freedom = static_cast<double>(rows.size() - linear - shapes);
  result.misfit = std::sqrt(fit.whitened_residual.squaredNorm() / std::max(1.0, freedom));
  result.outliers = fit.outliers;
  const Eigen::VectorXd sigma =
      fit.covariance.diagonal().cwiseSqrt() * std::max(1.0, result.misfit);
  const auto offset_values = fit.coefficients.tail(offsets.cols());
  result.run_offsets_dph.assign(offset_values.begin(), offset_values.end());
  for (std::size_t i = 0; i < model.terms.size(); ++i) {
    EffectTerm& term = model.terms[i];
    const auto values = fit.coefficients.segment(columns[i].first, columns[i].count);
    const auto sigmas = sigma.segment(columns[i].first, columns[i].count);
    term.coefficients_dph.assign(values.begin(), values.end());
    term.sigma_dph.assign(sigmas.begin(), sigmas.end());
    const Eigen::MatrixXd part = fit.columns.middleCols(columns[i].first, columns[i].count);
    const Eigen::MatrixXd covariance = fit.covariance.block(columns[i].first, columns[i].first,
                                                            columns[i].count, columns[i].count);
    const double largest_variance =
        (part * covariance).cwiseProduct(part).rowwise().sum().maxCoeff();
    result.visible_dph.push_back(kVisible * std::max(1.0, result.misfit) *
                                 std::sqrt(largest_variance));
  }
  for (std::size_t i = 0; i < fit.shapes.size(); ++i) {
    const ShapeParameter& shape = fit.shapes[i];
    EffectTerm& term = model.terms[shape.term];
    term.parameter_sigma[shape.index] =
        sigma[linear + static_cast<Eigen::Index>(i)] * shape.slope(term.parameters[shape.index]);
  }
  result.warnings = confusions(model.terms, columns, fit.covariance);
  set_ranges(model, rows);
  model.residual_rms_dph =
      std::sqrt(result.residual_dph.cwiseAbs2().dot(rows.weights) / rows.weights.sum());
  return result;
}

}  // namespace fogcomp
