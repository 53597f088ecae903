#include "fit/inexact_terms.hpp"

#include <algorithm>
#include <array>

#include "judge/likelihood.hpp"
#include "model/catalogue.hpp"
#include "series/rows.hpp"
#include "series/term_columns.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::fit {
namespace {

struct FittedTerms {
  const series::Rows& rows;
  const std::vector<model::EffectTerm>& terms;
  const Eigen::MatrixXd& columns;
  const Eigen::VectorXd& coefficients;
};

// Prior knowledge of how exactly the model's terms describe the physics, one standard deviation
// each. Time by which the sensor leads or lags the coil.
constexpr double kSensorDelay_s = 20;
// A part of a term's drift (judge::kInexact) bends with temperature, or follows the heat through a
// coil of many layers with such lags.
constexpr std::array<double, 2> kLags_s{60, 600};
constexpr Eigen::Index kBends = 2;  // orders T and T^2

// Drift of the model's terms, or of those of the temperature rate. Without what the input rate
// does, in which a sensor beside the coil has no part: a sine of the table that were a minute late
// would be all that a scale factor is.
Eigen::VectorXd thermal_drift(const FittedTerms& fit, bool of_rate_only) {
  Eigen::VectorXd drift = Eigen::VectorXd::Zero(fit.rows.size());
  const std::vector<series::ColumnRange> columns = series::columns_of(fit.terms, fit.rows.row_s);
  for (std::size_t term = 0; term < columns.size(); ++term) {
    const model::TermInfo info = model::info_of(fit.terms[term]);
    if (has(info.needs, fog::Input::input_rate)) continue;
    for (Eigen::Index i = 0; i < columns[term].count; ++i) {
      const auto& coefficient = info.coefficients[static_cast<std::size_t>(i)];
      if (of_rate_only && !model::of_temperature_rate(coefficient)) continue;
      const Eigen::Index column = columns[term].first + i;
      drift += fit.columns.col(column) * fit.coefficients[column];
    }
  }
  return drift;
}

// d/dt of a series of rows, per second; 0 at the ends of a run.
Eigen::VectorXd slope(const series::Rows& rows, const Eigen::VectorXd& values) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(values.size());
  for (Eigen::Index i = 1; i + 1 < values.size(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (rows.starts_run(row) || rows.starts_run(row + 1)) continue;
    result[i] = (values[i + 1] - values[i - 1]) / (rows.time_s[row + 1] - rows.time_s[row - 1]);
  }
  return result;
}

// Possible bending of each term: its drift without its mean, times Legendre polynomials of the
// temperature over the range of these rows.
Eigen::MatrixXd bent_terms(const FittedTerms& fit, const std::vector<std::size_t>& straight) {
  Eigen::ArrayXd degc(fit.rows.size());
  for (Eigen::Index i = 0; i < degc.size(); ++i) {
    degc[i] = fit.rows.signals[static_cast<std::size_t>(i)].temperature;
  }
  const double half_range = std::max((degc.maxCoeff() - degc.minCoeff()) / 2, 1e-9);
  const Eigen::ArrayXd u = (degc - (degc.maxCoeff() + degc.minCoeff()) / 2) / half_range;
  const std::vector<series::ColumnRange> columns = series::columns_of(fit.terms, fit.rows.row_s);
  Eigen::MatrixXd bent(fit.rows.size(), kBends * static_cast<Eigen::Index>(columns.size()));
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (std::find(straight.begin(), straight.end(), i) != straight.end()) continue;
    const auto [first, count] = columns[i];
    Eigen::ArrayXd drift =
        (fit.columns.middleCols(first, count) * fit.coefficients.segment(first, count)).array();
    drift -= drift.mean();
    drift *= judge::kInexact;
    bent.col(at++) = drift * u;
    bent.col(at++) = drift * (3 * u.square() - 1) / 2;
  }
  return bent.leftCols(at);
}

// `shifted`: drift that a sensor which leads or lags the coil shifts.
Eigen::MatrixXd timings(const FittedTerms& fit, const Eigen::VectorXd& shifted) {
  const Eigen::VectorXd of_rate = thermal_drift(fit, true);
  Eigen::MatrixXd timings(fit.rows.size(), 1 + kLags_s.size());
  timings.col(0) = kSensorDelay_s * slope(fit.rows, shifted);
  for (std::size_t i = 0; i < kLags_s.size(); ++i) {
    timings.col(static_cast<Eigen::Index>(i) + 1) =
        judge::kInexact * (of_rate - series::first_order_lag(fit.rows, of_rate, kLags_s[i]));
  }
  return timings;
}

}  // namespace

Eigen::MatrixXd inexact_terms(const series::Rows& rows, const std::vector<model::EffectTerm>& terms,
                              const Eigen::MatrixXd& columns, const Eigen::VectorXd& coefficients,
                              const std::vector<std::size_t>& straight) {
  const FittedTerms fit{rows, terms, columns, coefficients};
  return side_by_side({timings(fit, thermal_drift(fit, false)), bent_terms(fit, straight)},
                      rows.size());
}

Eigen::MatrixXd inexact_rate_terms(const series::Rows& rows,
                                   const std::vector<model::EffectTerm>& terms,
                                   const Eigen::MatrixXd& columns,
                                   const Eigen::VectorXd& coefficients) {
  const FittedTerms fit{rows, terms, columns, coefficients};
  return timings(fit, thermal_drift(fit, true));
}

Eigen::VectorXd unresolved_drift(const series::Rows& rows,
                                 const std::vector<model::EffectTerm>& terms,
                                 const Eigen::MatrixXd& columns,
                                 const Eigen::VectorXd& coefficients, double time_s) {
  const Eigen::VectorXd drift = thermal_drift({rows, terms, columns, coefficients}, false);
  return time_s * time_s * slope(rows, slope(rows, drift));
}

}  // namespace fogcomp::fit
