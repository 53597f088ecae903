#include "compare/board_delay.hpp"

#include <algorithm>
#include <cmath>

#include "compare/decision_rules.hpp"
#include "series/signal_series.hpp"
#include "support/text.hpp"

namespace fogcomp::compare {
namespace {

struct Delay {
  Eigen::VectorXd drift_dph;  // per row: as the board computes it, less the gyro's own
  Eigen::VectorXd weights;
};

Delay delay_of(const model::Model& model, const runs::Run& run) {
  series::SignalSeries series(model);
  series.add(run.blocks);
  return {series.drift_dph(model.terms) - series.drift_dph(model.terms, series::Reading::of_gyro),
          series.rows().weights};
}

}  // namespace

void BoardError::add(const BoardError& other) {
  const auto pooled = [&](double own, double others) {
    const double square = rows * own * own + other.rows * others * others;
    return std::sqrt(square / std::max(rows + other.rows, 1e-300));
  };
  rms_dph = pooled(rms_dph, other.rms_dph);
  without_delay_dph = pooled(without_delay_dph, other.without_delay_dph);
  rows += other.rows;
}

bool BoardError::delay_matters() const {
  return rms_dph - without_delay_dph > rules::kTellsApart * rms_dph;
}

std::string delay_words(const BoardError& error) {
  return format(
      "as the board computes it, the model leaves %.4g deg/h rms; without the board's delay (block "
      "means, derivative filter) it would leave %.4g",
      error.rms_dph, error.without_delay_dph);
}

BoardError board_error(const model::Model& model, const runs::Run& run,
                       const Comparison& comparison) {
  model::Model averaging = model;
  averaging.average_s = comparison.rows.row_s;
  const Delay delay = delay_of(averaging, run);
  BoardError error{comparison.whole.rms_dph, 0, 0};
  double square = 0;
  const std::vector<double> residuals = comparison.residuals_dph();
  for (std::size_t i = 0; i < comparison.size(); ++i) {
    if (comparison.outlier[i]) continue;
    const auto row = static_cast<Eigen::Index>(i);
    const double weight = comparison.rows.weights[row];
    const double residual = residuals[i] + delay.drift_dph[row];
    square += weight * residual * residual;
    error.rows += weight;
  }
  error.without_delay_dph = std::sqrt(square / std::max(error.rows, 1e-300));
  return error;
}

}  // namespace fogcomp::compare
