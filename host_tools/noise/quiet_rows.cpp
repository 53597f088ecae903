#include "noise/quiet_rows.hpp"

#include <algorithm>
#include <cmath>

#include "model/input_value.hpp"
#include "noise/decision_rules.hpp"
#include "support/evidence.hpp"
#include "support/statistics.hpp"

namespace fogcomp::noise {
namespace {

double rate_limit(const series::Rows& rows) {
  std::vector<double> rates;
  for (const auto& signals : rows.signals) rates.push_back(std::abs(signals.temperature_rate));
  const auto at = rates.begin() + static_cast<std::ptrdiff_t>(
                                      rules::kRampQuantile * static_cast<double>(rates.size() - 1));
  std::nth_element(rates.begin(), at, rates.end());
  return std::max(rules::kMaxQuietRate, rules::kQuietShareOfRamps * *at);
}

// Finds changes of other inputs, which change a residual and are not noise: a rotation of the axis,
// a field that is switched, a table that turns.
class InputChanges {
 public:
  explicit InputChanges(const series::Rows& rows) : rows_(rows) {
    for (std::size_t i = 0; i < kValues; ++i) {
      double min = HUGE_VAL;
      double max = -HUGE_VAL;
      for (std::size_t row = 0; row < rows.signals.size(); ++row) {
        min = std::min(min, value(row, i));
        max = std::max(max, value(row, i));
      }
      if (!(max > min)) continue;
      std::vector<double> steps;
      for (std::size_t row = 1; row < rows.signals.size(); ++row) {
        steps.push_back(value(row, i) - value(row - 1, i));
      }
      changes_.push_back(
          {i, std::max(rules::kOtherInput * (max - min), kCertainSigmas * sigma_by_median(steps)),
           HUGE_VAL});
      if (model::kOptionalInputs[i] == fog::Input::input_rate) {
        changes_.back().max = std::max(rules::kMaxTurning * (max - min), rules::kMinTurning_dph);
      }
    }
  }
  // `before`: the row before; `begin`: the first of the range.
  bool at(std::size_t row, std::size_t before, std::size_t begin) const {
    return std::any_of(changes_.begin(), changes_.end(), [&](const Change& change) {
      const auto since = [&](std::size_t other) {
        return std::abs(value(row, change.input) - value(other, change.input));
      };
      return since(before) > change.jump || since(begin) > change.max;
    });
  }

 private:
  static constexpr std::size_t kValues = model::kOptionalInputs.size();
  struct Change {
    std::size_t input;
    double jump;  // from row to row
    double max;   // within a range
  };

  double value(std::size_t row, std::size_t i) const {
    return model::optional_input(model::kOptionalInputs[i], rows_.inputs[row]);
  }

  const series::Rows& rows_;
  std::vector<Change> changes_;
};

}  // namespace

std::vector<recording::RowRange> quiet_ranges(const series::Rows& rows) {
  std::vector<recording::RowRange> ranges;
  const auto size = static_cast<std::size_t>(rows.size());
  if (size < kEnoughValues) return ranges;
  const double limit = rate_limit(rows);
  const InputChanges changes(rows);
  std::size_t begin = 0;
  const auto finish = [&](std::size_t end) {
    if (end - begin >= kEnoughValues) ranges.push_back({begin, end});
  };
  for (std::size_t row = 0; row < size; ++row) {
    const bool quiet = std::abs(rows.signals[row].temperature_rate) <= limit;
    if (quiet && (row == begin || (rows.follows(row) && !changes.at(row, row - 1, begin))))
      continue;
    finish(row);
    begin = quiet ? row : row + 1;
  }
  finish(size);
  return ranges;
}

std::vector<Eigen::VectorXd> parts_of(const Eigen::VectorXd& values,
                                      const std::vector<recording::RowRange>& ranges) {
  std::vector<Eigen::VectorXd> parts;
  for (const recording::RowRange& range : ranges) {
    parts.push_back(series::of_rows(values, range));
  }
  return parts;
}

std::vector<Eigen::VectorXd> quiet_stretches(const series::Rows& rows,
                                             const Eigen::VectorXd& residual) {
  return parts_of(residual, quiet_ranges(rows));
}

NoiseModel noise_of(const series::Rows& rows, const Eigen::VectorXd& residual) {
  const std::vector<Eigen::VectorXd> quiet = quiet_stretches(rows, residual);
  if (quiet.empty()) return white_noise_of(residual, rows.row_s, rows.longest_run_s());
  return fit_noise(noise_samples(quiet), rows.row_s, rows.longest_run_s());
}

}  // namespace fogcomp::noise
