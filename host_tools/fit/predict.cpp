#include "fit/predict.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/inexact_terms.hpp"
#include "support/least_squares.hpp"
#include "support/units.hpp"

namespace fogcomp::fit {

namespace {

// Root mean square of what a change of the temperature by 1 degC, or of its rate by 1 degC/min,
// makes of the drift.
double slope(const KnownRegressors& known, const NoiseWeightedFit& fit,
             const series::TemperatureChange& change) {
  const series::Rows& rows = known.series().rows();
  const std::vector<series::ColumnRange> columns = series::columns_of(fit.terms, rows.row_s);
  Eigen::VectorXd above = Eigen::VectorXd::Zero(rows.size());
  for (std::size_t i = 0; i < fit.terms.size(); ++i) {
    const auto [first, count] = columns[i];
    const KnownRegressors::Columns changed = known(fit.terms[i], series::Reading::of_gyro, change);
    above +=
        (*changed - fit.columns.middleCols(first, count)) * fit.coefficients.segment(first, count);
  }
  return std::sqrt(above.squaredNorm() / static_cast<double>(above.size()));
}

// Unknowns of judged rows in those of which a prior knows that they are independent. What lies
// between coefficients and shapes is not the prior's.
Independent independent_unknowns(const NoiseWeightedFit& fit, series::Reading reading,
                                 Eigen::Index count) {
  const auto shapes = static_cast<Eigen::Index>(fit.shapes.size());
  Eigen::VectorXd positions(shapes);
  for (Eigen::Index i = 0; i < shapes; ++i) {
    const model::ShapeParameter& shape = fit.shapes[static_cast<std::size_t>(i)];
    positions[i] = shape.unit_in(fit.terms[shape.term]);
  }
  const Independent own = independent(*fit.prior, reading, positions);
  const Eigen::Index coefficients = own.origin.size() - shapes;
  Independent all{Eigen::VectorXd::Zero(count), Eigen::MatrixXd::Identity(count, count)};
  all.origin.head(coefficients) = own.origin.head(coefficients);
  all.slopes.topLeftCorner(coefficients, coefficients) =
      own.slopes.topLeftCorner(coefficients, coefficients);
  all.slopes.topRightCorner(coefficients, shapes) = own.slopes.topRightCorner(coefficients, shapes);
  all.slopes.bottomRightCorner(shapes, shapes) = own.slopes.bottomRightCorner(shapes, shapes);
  return all;
}

// With the prior of a fit, if it has one.
judge::Prediction prediction(judge::Rows judged, const NoiseWeightedFit& fit,
                             series::Reading reading) {
  if (!fit.prior) return judge::Prediction(judged);
  const Eigen::Index count = judged.columns.cols();
  const Independent unknowns = independent_unknowns(fit, reading, count);
  judged.drift_dph -= judged.columns * unknowns.origin;
  judged.columns = (judged.columns * unknowns.slopes).eval();
  judged.prior_sigma.head(fit.prior->coefficients()).setOnes();
  judged.prior_sigma.tail(static_cast<Eigen::Index>(fit.shapes.size())).setOnes();
  return judge::Prediction(judged).of(unknowns.origin, unknowns.slopes);
}

}  // namespace

judge::TemperatureError temperature_error(const KnownRegressors& known,
                                          const NoiseWeightedFit& fit) {
  // Small beside what bends a drift with temperature, large beside rounding.
  constexpr double kSmall = 1e-3;
  judge::TemperatureError error;
  error.white_degc2_s = known.series().thermometer().white_degc2_s;
  error.rate_walk_degc2_per_s3 = known.series().thermometer().rate_walk_degc2_per_s3;
  error.slope_dph_per_degc = slope(known, fit, {kSmall, 0}) / kSmall;
  error.slope_dph_min_per_degc = slope(known, fit, {0, kSmall}) / kSmall;
  return error;
}

noise::NoiseModel noise_model(const judge::NoiseLevels& levels, const series::Rows& rows) {
  constexpr double kStep = 4;    // of the time constants, whose spectra sum to 1/f
  constexpr double kLonger = 4;  // so many recordings: a component that walks
  constexpr double kMinWhite = 1e-15;
  const double longest_s = rows.longest_run_s();
  noise::NoiseModel noise;
  noise.row_s = rows.row_s;
  noise.white_variance = std::pow(std::max(levels.white_dph, kMinWhite), 2);
  const double each = std::pow(levels.flicker_dph, 2) * std::log(kStep) / kPi;
  for (double tau_s = 2 * rows.row_s; tau_s <= longest_s; tau_s *= kStep) {
    noise.components.push_back({tau_s, each});
  }
  const double walk_per_s = std::pow(levels.walk_dph_per_rth, 2) / kSecondsPerHour;
  noise.components.push_back({kLonger * longest_s, walk_per_s * kLonger * longest_s / 2});
  return noise;
}

noise::NoiseModel noise_beside(const PossibleDrift& possible, const series::Rows& rows,
                               const Eigen::VectorXd& drift_dph, const Eigen::VectorXd& weights) {
  judge::Rows judged;
  judged.row_s = rows.row_s;
  judged.drift_dph = drift_dph;
  judged.columns = possible.columns;
  judged.prior_sigma = possible.prior_sigma;
  judged.first_found = possible.first_found;
  judged.weights = weights;
  judged.stretches = rows.stretches();
  return noise_model(judge::Prediction(judged).noise(), rows);
}

judge::Rows judged_rows(const series::Rows& rows, const NoiseWeightedFit& fit,
                        const series::ColumnRange& without) {
  judge::Rows judged;
  judged.row_s = rows.row_s;
  judged.drift_dph = rows.drift_dph;
  const Eigen::Index behind = fit.linear() - without.first - without.count;
  judged.columns = side_by_side(
      {fit.columns.leftCols(without.first), fit.columns.rightCols(behind), fit.shape_columns},
      rows.size());
  judged.prior_sigma = Eigen::VectorXd::Zero(judged.columns.cols());
  judged.prior_sigma.tail(fit.shape_columns.cols()).setConstant(kSigmaOfPosition);
  judged.first_found = fit.linear() - without.count;
  judged.weights = fit.row_weights;
  judged.stretches = rows.stretches();
  return judged;
}

void add_nuisances(const Eigen::MatrixXd& nuisances, double sigma, judge::Rows& judged) {
  const Eigen::Index before = judged.first_found;
  const Eigen::Index shapes = judged.columns.cols() - before;
  judged.columns =
      side_by_side({judged.columns.leftCols(before), nuisances, judged.columns.rightCols(shapes)},
                   judged.size());
  Eigen::VectorXd prior_sigma(judged.columns.cols());
  prior_sigma << judged.prior_sigma.head(before),
      Eigen::VectorXd::Constant(nuisances.cols(), sigma), judged.prior_sigma.tail(shapes);
  judged.prior_sigma = std::move(prior_sigma);
  judged.first_found += nuisances.cols();
}

void add_biases(const series::Rows& rows, judge::Rows& judged) {
  for (const recording::RowRange& range : rows.bias_ranges()) {
    if (!rows.is_cut_at(range.end)) {
      judged.power_ons.push_back(range);
      continue;
    }
    Eigen::VectorXd before_cut = Eigen::VectorXd::Zero(rows.size());
    series::of_rows(before_cut, range).setOnes();
    add_nuisances(before_cut, 0, judged);
  }
  if (judged.power_ons.size() == 1) judged.power_ons.clear();
}

noise::NoiseModel noise_beside(const series::Rows& rows, const NoiseWeightedFit& fit) {
  return noise_model(predict(rows, fit).noise(), rows);
}

judge::Prediction predict(const series::Rows& rows, const NoiseWeightedFit& fit,
                          series::Reading reading) {
  return prediction(judged_rows(rows, fit, {fit.linear(), 0}), fit, reading);
}

judge::Prediction predict(const series::Rows& rows, const NoiseWeightedFit& fit,
                          const series::ColumnRange& offsets,
                          const judge::TemperatureError& temperature) {
  judge::Rows judged = judged_rows(rows, fit, offsets);
  // Without them what a coil's lag leaves of each ramp is taken for a random walk, whose slow part
  // no row shows.
  add_nuisances(inexact_rate_terms(rows, fit.terms, fit.columns, fit.coefficients), 1, judged);
  add_biases(rows, judged);
  judged.temperature = temperature;
  return prediction(std::move(judged), fit, series::Reading::of_gyro);
}

}  // namespace fogcomp::fit
