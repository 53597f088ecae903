#include "noise/outlier_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "model/input_value.hpp"
#include "noise/decision_rules.hpp"
#include "support/evidence.hpp"
#include "support/statistics.hpp"
#include "support/text.hpp"

namespace fogcomp::noise {
namespace {

// Quantile of `sizes`; `part`: 0..1.
double quantile(std::vector<double>& sizes, double part) {
  const auto at =
      sizes.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), at, sizes.end());
  return *at;
}

// Standard deviation of a row's white noise, from second differences; robust against few outliers.
// The larger estimate of two quantiles: in an oscillation every second difference may vanish, or
// most may be nearly as large as the largest.
double sigma_of_bends(std::vector<double> bends) {
  constexpr double kNormalHalf = 0.67448975019608171;  // quantiles of |normal|
  constexpr double kNormalThreeQuarters = 1.1503493803760079;
  const double root = std::sqrt(6.0);
  if (bends.empty()) return 0;
  for (double& bend : bends) bend = std::abs(bend);
  const double sigma =
      std::max(quantile(bends, 0.5) / kNormalHalf, quantile(bends, 0.75) / kNormalThreeQuarters);
  if (sigma > 0) return sigma / root;
  // The resolution is coarser than the noise: most rows are equal, the others give its size.
  bends.erase(std::remove(bends.begin(), bends.end(), 0.0), bends.end());
  return sigma_by_median(std::move(bends)) / root;
}

// Chauvenet's criterion: noise alone is expected to exceed it in half a row.
double max_sigmas(std::size_t rows) {
  double low = kRareSigmas;
  double high = 10;  // noise of no recording reaches it
  while (high - low > 1e-3) {
    const double middle = (low + high) / 2;
    const double beyond = static_cast<double>(rows) * std::erfc(middle / std::sqrt(2.0));
    (beyond > rules::kRowsBeyond ? low : high) = middle;
  }
  return low;
}

// The nearest values on one side of a row.
class Side {
 public:
  // Sorted.
  void add(double value) {
    std::size_t at = size_++;
    for (; at > 0 && values_[at - 1] > value; --at) values_[at] = values_[at - 1];
    values_[at] = value;
  }
  std::size_t size() const { return size_; }
  double median() const { return (values_[(size_ - 1) / 2] + values_[size_ / 2]) / 2; }
  // Standard deviation from the median of the three distances from the median, of which one is 0.
  double scatter() const {
    constexpr double kSigmaPerMedian = 1.4826022185056018;
    if (size_ < rules::kNeighbours) return 0;
    return kSigmaPerMedian * std::min(values_[2] - values_[1], values_[1] - values_[0]);
  }
  double range() const { return values_[size_ - 1] - values_[0]; }

 private:
  std::array<double, rules::kNeighbours> values_{};
  std::size_t size_ = 0;
};

class OutlierSearch {
 public:
  explicit OutlierSearch(const ValuesInTime& rows) : rows_(rows), outlier_(rows.values.size()) {
    for (const std::vector<double>& input : rows.inputs) {
      if (input.empty()) continue;
      const auto [min, max] = std::minmax_element(input.begin(), input.end());
      if (*max > *min) inputs_.push_back({&input, rules::kOtherInput * (*max - *min)});
    }
    std::vector<double> bends;
    for (const recording::RowRange& stretch : rows.stretches) {
      for (std::size_t i = stretch.first + 1; i + 1 < stretch.end; ++i) bends.push_back(bend(i));
    }
    sigma_ = sigma_of_bends(std::move(bends));
    sigmas_ = max_sigmas(rows.values.size());
  }

  // Rows of one event are found one after the other, because each hides the next.
  std::vector<bool> run() {
    if (sigma_ == 0) return outlier_;
    for (std::size_t round = 0; round <= rules::kNeighbours; ++round) {
      std::vector<std::size_t> found;
      for (const recording::RowRange& stretch : rows_.stretches) {
        for (std::size_t i = stretch.first; i < stretch.end; ++i) {
          if (!outlier_[i] && stands_out(i, stretch)) found.push_back(i);
        }
      }
      if (found.empty()) break;
      for (const std::size_t i : found) outlier_[i] = true;
    }
    return outlier_;
  }

 private:
  struct Input {
    const std::vector<double>* values;
    double same;
  };

  double bend(std::size_t i) const {
    return rows_.values[i - 1] - 2 * rows_.values[i] + rows_.values[i + 1];
  }

  bool comparable(std::size_t a, std::size_t b) const {
    return std::all_of(inputs_.begin(), inputs_.end(), [&](const Input& input) {
      return std::abs((*input.values)[a] - (*input.values)[b]) <= input.same;
    });
  }

  Side side_of(std::size_t row, const recording::RowRange& stretch, std::ptrdiff_t step) const {
    Side side;
    const std::size_t available = step < 0 ? row - stretch.first : stretch.end - 1 - row;
    for (std::size_t away = 1;
         away <= std::min(available, rules::kNeighbourReach) && side.size() < rules::kNeighbours;
         ++away) {
      const auto i = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(row) +
                                              step * static_cast<std::ptrdiff_t>(away));
      if (!outlier_[i] && comparable(row, i)) side.add(rows_.values[i]);
    }
    return side;
  }

  bool stands_out(std::size_t row, const recording::RowRange& stretch) const {
    const Side before = side_of(row, stretch, -1);
    const Side after = side_of(row, stretch, 1);
    const double value = rows_.values[row];
    const double weight = rows_.weights.empty() ? 1 : std::min(1.0, rows_.weights[row]);
    const double allowed = sigmas_ / std::sqrt(weight);
    double off = 0;
    double scatter = 0;
    if (before.size() > 0 && after.size() > 0) {
      if ((value > before.median()) != (value > after.median())) return false;
      off = std::min(std::abs(value - before.median()), std::abs(value - after.median()));
      scatter = std::max(before.scatter(), after.scatter());
    } else {
      // At the end of a stretch only its size distinguishes an outlier from a growing drift.
      const Side& side = before.size() > 0 ? before : after;
      if (side.size() < rules::kNeighbours) return false;
      off = std::abs(value - side.median());
      scatter = side.range();
    }
    return off > allowed * sigma_ && off > rules::kOutlierScatters * scatter &&
           off > allowed * sigma_around(row, stretch);
  }

  // Without the row itself; 0 for too few rows.
  double sigma_around(std::size_t row, const recording::RowRange& stretch) const {
    std::vector<double> bends;
    const std::size_t first = std::max(stretch.first + 1, row - std::min(row, rules::kRowsAround));
    const std::size_t end = std::min(stretch.end, row + rules::kRowsAround + 2);
    for (std::size_t i = first; i + 1 < end; ++i) {
      if (i + 1 < row || i > row + 1) bends.push_back(bend(i));
    }
    return bends.size() < kFewValues ? 0 : sigma_of_bends(std::move(bends));
  }

  const ValuesInTime& rows_;
  std::vector<Input> inputs_;
  std::vector<bool> outlier_;
  double sigma_ = 0;
  double sigmas_ = 0;
};

}  // namespace

std::vector<bool> find_outliers(const ValuesInTime& rows) {
  return OutlierSearch(rows).run();
}

Eigen::VectorXd counted_rows(const series::Rows& rows) {
  ValuesInTime in_time;
  in_time.values.assign(rows.drift_dph.begin(), rows.drift_dph.end());
  in_time.weights.assign(rows.weights.begin(), rows.weights.end());
  in_time.stretches = rows.stretches();
  for (const fog::Input input : model::kOptionalInputs) {
    std::vector<double>& values = in_time.inputs.emplace_back();
    for (const auto& means : rows.inputs) values.push_back(model::optional_input(input, means));
  }
  const std::vector<bool> outlier = find_outliers(in_time);
  Eigen::VectorXd counted(rows.size());
  for (Eigen::Index row = 0; row < rows.size(); ++row) {
    counted[row] = outlier[static_cast<std::size_t>(row)] ? 0 : 1;
  }
  return counted;
}

Eigen::VectorXd counted_weights(const series::Rows& rows, const Eigen::VectorXd& row_weights) {
  return (row_weights.array() > 0).select(rows.weights.array(), 0.0).matrix();
}

void bridge_outliers(const std::vector<bool>& outlier,
                     const std::vector<recording::RowRange>& stretches,
                     std::vector<double>& values) {
  for (const recording::RowRange& stretch : stretches) {
    for (std::size_t i = stretch.first; i < stretch.end; ++i) {
      if (!outlier[i]) continue;
      std::size_t end = i;
      while (end < stretch.end && outlier[end]) ++end;
      const bool has_before = i > stretch.first;
      const bool has_after = end < stretch.end;
      if (!has_before && !has_after) break;
      const double from = has_before ? values[i - 1] : values[end];
      const double to = has_after ? values[end] : values[i - 1];
      const auto steps = static_cast<double>(end - i + 1);
      for (std::size_t k = i; k < end; ++k) {
        values[k] = from + (to - from) * static_cast<double>(k - i + 1) / steps;
      }
      i = end - 1;
    }
  }
}

Eigen::VectorXd bridged(const series::Rows& rows, const Eigen::VectorXd& values,
                        const Eigen::VectorXd& counted) {
  std::vector<bool> outlier;
  for (const double count : counted) outlier.push_back(count <= 0);
  std::vector<double> bridge(values.begin(), values.end());
  bridge_outliers(outlier, rows.stretches(), bridge);
  return Eigen::Map<const Eigen::VectorXd>(bridge.data(), values.size());
}

std::string outlier_words(std::size_t rows, double row_s) {
  if (rows == 0) return "";
  return format(
      "%s of %.4g s left out: %s out of its neighbours by more than %g sigma of the noise",
      counted(rows, "row").c_str(), row_s, rows == 1 ? "it stands" : "each stands", kRareSigmas);
}

}  // namespace fogcomp::noise
