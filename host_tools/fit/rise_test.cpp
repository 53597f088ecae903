#include "fit/rise_test.hpp"

#include <algorithm>
#include <cmath>

#include "fit/decision_rules.hpp"
#include "noise/autocorrelation.hpp"

namespace fogcomp::fit {

void RiseTest::add(const compare::Comparison& before, const compare::Comparison& after) {
  const std::size_t first = rise_.size();
  const auto residuals = [&](const compare::Comparison& of) {
    return run_offsets_ ? of.residuals_about_bias_dph() : of.residuals_dph();
  };
  const std::vector<double> residual_before = residuals(before);
  const std::vector<double> residual_after = residuals(after);
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before.outlier[i]) continue;
    const double weight = before.rows.weights[static_cast<Eigen::Index>(i)];
    const double square_before = std::pow(residual_before[i], 2);
    const double square_after = std::pow(residual_after[i], 2);
    rise_.push_back(square_after - square_before);
    before_ += weight * square_before;
    after_ += weight * square_after;
    weight_ += weight;
  }
  runs_.push_back({first, rise_.size()});
}

bool RiseTest::rose() const {
  const auto rows = static_cast<double>(rise_.size());
  double sum = 0;
  double squares = 0;
  for (const double one : rise_) {
    sum += one;
    squares += one * one;
  }
  const double variance = squares - sum * sum / std::max(1.0, rows);
  return sum > rules::kOneIn100 * std::sqrt(variance * noise::correlated_values(rise_, runs_));
}

model::HistoryEntry::Holdout RiseTest::rms_dph() const {
  return {std::sqrt(before_ / weight_), std::sqrt(after_ / weight_)};
}

}  // namespace fogcomp::fit
