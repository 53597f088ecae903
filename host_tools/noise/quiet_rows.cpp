#include "noise/quiet_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/input_value.hpp"
#include "noise/decision_rules.hpp"

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

// Finds changes such as a rotation of the axis or a field that is switched, which are not noise.
class InputJumps {
 public:
  explicit InputJumps(const series::Rows& rows) : rows_(rows) {
    for (std::size_t i = 0; i < kValues; ++i) {
      double min = HUGE_VAL;
      double max = -HUGE_VAL;
      for (const auto& signals : rows.signals) {
        min = std::min(min, value(signals, i));
        max = std::max(max, value(signals, i));
      }
      jump_[i] = rules::kInputJump * (max - min);
    }
  }
  bool between(std::size_t before, std::size_t row) const {
    for (std::size_t i = 0; i < kValues; ++i) {
      const double change =
          std::abs(value(rows_.signals[row], i) - value(rows_.signals[before], i));
      if (jump_[i] > 0 && change > jump_[i]) return true;
    }
    return false;
  }

 private:
  static constexpr std::size_t kValues = model::kOptionalInputs.size();
  static double value(const fog::Signals<model::RealNumbers>& signals, std::size_t i) {
    return model::optional_input(model::kOptionalInputs[i], signals.block);
  }

  const series::Rows& rows_;
  std::array<double, kValues> jump_{};
};

}  // namespace

std::vector<recording::RowRange> quiet_ranges(const series::Rows& rows) {
  std::vector<recording::RowRange> ranges;
  const auto size = static_cast<std::size_t>(rows.size());
  if (size < rules::kMinQuietRows) return ranges;
  const double limit = rate_limit(rows);
  const InputJumps jumps(rows);
  std::size_t begin = 0;
  const auto finish = [&](std::size_t end) {
    if (end - begin >= rules::kMinQuietRows) ranges.push_back({begin, end});
  };
  for (std::size_t row = 0; row < size; ++row) {
    const bool quiet = std::abs(rows.signals[row].temperature_rate) <= limit;
    if (quiet && (row == begin || (rows.follows(row) && !jumps.between(row - 1, row)))) continue;
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
