#include "fit/soak_uncertainty.hpp"

#include <cmath>

#include "model/catalogue.hpp"
#include "series/term_columns.hpp"

namespace fogcomp::fit {
namespace {

using Signals = fog::Signals<model::RealNumbers>;

// Means of all signals, with temperature rate 0.
Signals mean_signals(const series::Rows& rows) {
  Signals mean;
  const auto count = static_cast<double>(rows.signals.size());
  for (std::size_t row = 0; row < rows.signals.size(); ++row) {
    const Signals& signals = rows.signals[row];
    mean.temperature += signals.temperature / count;
    mean.block.input_rate += signals.block.input_rate / count;
    mean.block.elapsed += rows.time_s[row] / rows.row_s / count;
    for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
      mean.block.extension[i] += signals.block.extension[i] / count;
    }
  }
  return mean;
}

Eigen::VectorXd regressors(const model::EffectTerm& term, const Signals& signals, double row_s) {
  const auto effect = model::make_effect(term, row_s);
  Eigen::VectorXd values(static_cast<Eigen::Index>(effect->regressor_count()));
  effect->reset(signals);
  effect->step(signals, values.data());
  return values;
}

// Derivative of the drift by each unknown, in the order of the fit's covariance.
Eigen::VectorXd gradient(const std::vector<model::EffectTerm>& terms, const NoiseWeightedFit& fit,
                         const Signals& signals, double row_s) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(fit.covariance.rows());
  const std::vector<series::ColumnRange> columns = series::columns_of(terms, row_s);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    result.segment(columns[i].first, columns[i].count) = regressors(terms[i], signals, row_s);
  }
  for (std::size_t i = 0; i < fit.shapes.size(); ++i) {
    const model::ShapeParameter& shape = fit.shapes[i];
    const series::ColumnRange& range = columns[shape.term];
    result[fit.linear() + static_cast<Eigen::Index>(i)] = model::derivative_by_unit(
        shape, terms[shape.term], [&](const model::EffectTerm& moved) -> double {
          return regressors(moved, signals, row_s)
              .dot(fit.coefficients.segment(range.first, range.count));
        });
  }
  return result;
}

}  // namespace

SoakUncertainty soak_uncertainty(const model::Model& model, const NoiseWeightedFit& fit,
                                 const Eigen::MatrixXd& covariance, const series::Rows& rows,
                                 bool at_power_on) {
  constexpr int kTemperatures = 33;
  Signals signals = mean_signals(rows);
  if (at_power_on) signals.block.elapsed = 0;
  // A second sensor settles as far from the first as it is on average.
  const double second_above = signals.block[fog::Input::temperature2] - signals.temperature;
  SoakUncertainty worst;
  for (int i = 0; i < kTemperatures; ++i) {
    const double share = static_cast<double>(i) / (kTemperatures - 1);
    signals.temperature = model.min_degc + share * (model.max_degc - model.min_degc);
    signals.block.temperature = signals.temperature;
    signals.block[fog::Input::temperature2] = signals.temperature + second_above;
    const Eigen::VectorXd slope = gradient(fit.terms, fit, signals, rows.row_s);
    const double sigma_dph = std::sqrt(std::max(0.0, slope.dot(covariance * slope)));
    if (sigma_dph <= worst.sigma_dph) continue;
    worst = {sigma_dph, signals.temperature};
  }
  return worst;
}

}  // namespace fogcomp::fit
