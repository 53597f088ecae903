#include "noise/jumps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "noise/decision_rules.hpp"
#include "support/evidence.hpp"
#include "support/statistics.hpp"

namespace fogcomp::noise {
namespace {

// Replaces a row that deviates far from both neighbours by the nearer one: it would count as a
// jump.
Eigen::VectorXd without_spikes(const Eigen::VectorXd& values) {
  std::vector<double> steps;
  for (Eigen::Index i = 1; i < values.size(); ++i) steps.push_back(values[i] - values[i - 1]);
  const double far = kPossibleSigmas * sigma_by_median(std::move(steps));
  Eigen::VectorXd smooth = values;
  for (Eigen::Index i = 1; i + 1 < values.size(); ++i) {
    const auto [min, max] = std::minmax({values[i - 1], values[i + 1]});
    if (values[i] < min - far) smooth[i] = min;
    if (values[i] > max + far) smooth[i] = max;
  }
  return smooth;
}

// Cumulative sums, so that a mean costs two reads.
class Levels {
 public:
  explicit Levels(const Eigen::VectorXd& values) : sums_(values.size() + 1) {
    sums_[0] = 0;
    for (Eigen::Index i = 0; i < values.size(); ++i) sums_[i + 1] = sums_[i] + values[i];
  }
  Eigen::Index rows() const { return sums_.size() - 1; }
  // Mean of the rows from `row` on less that of the rows before it.
  double change_at(Eigen::Index row, Eigen::Index width) const {
    return (sums_[row + width] - 2 * sums_[row] + sums_[row - width]) / static_cast<double>(width);
  }

 private:
  Eigen::VectorXd sums_;
};

class Jumps {
 public:
  explicit Jumps(const std::vector<Eigen::VectorXd>& stretches) {
    for (const Eigen::VectorXd& stretch : stretches) levels_.emplace_back(without_spikes(stretch));
    for (std::size_t i = 0; i < rules::kJumpWidths.size(); ++i)
      sigma_[i] = sigma_of_changes(rules::kJumpWidths[i]);
  }

  // Rows of a stretch, between `begin` and `end`, at which a new level begins; in order.
  void find(std::size_t stretch, Eigen::Index begin, Eigen::Index end,
            std::vector<Eigen::Index>& rows) const {
    const auto row = highest(levels_[stretch], begin, end);
    if (!row) return;
    find(stretch, begin, *row, rows);
    rows.push_back(*row);
    find(stretch, *row, end, rows);
  }

 private:
  double sigma_of_changes(Eigen::Index width) const {
    const Eigen::Index step = width / 8;
    std::vector<double> changes;
    for (const Levels& levels : levels_) {
      for (Eigen::Index row = width; row + width <= levels.rows(); row += step) {
        changes.push_back(levels.change_at(row, width));
      }
    }
    const auto places =
        changes.size() * static_cast<std::size_t>(step) / static_cast<std::size_t>(2 * width);
    const double sigma = places < kFewValues ? 0 : sigma_by_median(std::move(changes));
    return sigma > 0 ? sigma : HUGE_VAL;  // nothing is significant
  }

  std::optional<Eigen::Index> highest(const Levels& levels, Eigen::Index begin,
                                      Eigen::Index end) const {
    std::optional<Eigen::Index> found;
    double max = rules::kMinJump;
    for (std::size_t i = 0; i < rules::kJumpWidths.size(); ++i) {
      const Eigen::Index away = std::max<Eigen::Index>(rules::kJumpWidths[i], kEnoughValues);
      for (Eigen::Index row = begin + away; row + away <= end; ++row) {
        const double change = levels.change_at(row, rules::kJumpWidths[i]);
        const double height = std::abs(change) / sigma_[i];
        if (height <= max) continue;
        if (levels.change_at(row, rules::kJumpWidths[i] / 2) / change < rules::kMinJumpShare)
          continue;
        max = height;
        found = row;
      }
    }
    return found;
  }

  std::vector<Levels> levels_;
  std::array<double, rules::kJumpWidths.size()> sigma_{};
};

}  // namespace

std::vector<Eigen::VectorXd> split_at_jumps(const std::vector<Eigen::VectorXd>& stretches) {
  const Jumps jumps(stretches);
  std::vector<Eigen::VectorXd> parts;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    std::vector<Eigen::Index> rows{0};
    jumps.find(i, 0, stretches[i].size(), rows);
    rows.push_back(stretches[i].size());
    for (std::size_t part = 1; part < rows.size(); ++part) {
      parts.push_back(stretches[i].segment(rows[part - 1], rows[part] - rows[part - 1]));
    }
  }
  return parts;
}

}  // namespace fogcomp::noise
