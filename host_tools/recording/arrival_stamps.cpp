#include "recording/arrival_stamps.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "recording/balanced_sums.hpp"
#include "recording/decision_rules.hpp"
#include "recording/row_range.hpp"
#include "recording/stretches.hpp"
#include "support/median.hpp"

namespace fogcomp::recording {
namespace {

using Ranges = std::vector<RowRange>;

std::size_t gaps_in(const std::vector<double>& time_s, double period_s) {
  std::size_t gaps = 0;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    if (is_gap(time_s[i] - time_s[i - 1], period_s)) ++gaps;
  }
  return gaps;
}

/// Rows sampled each `period_s`, in ranges between which samples are lost.
class EvenRows {
 public:
  explicit EvenRows(const std::vector<double>& time_s) : stamp_s_(time_s) {
    ranges_ = split_at([&](std::size_t row) { return spacing_s(row) > rules::kMaxDropoutS; });
    double sum_s = 0;
    std::size_t spacings = 0;
    for (const RowRange& range : ranges_) {
      sum_s += stamp_s_[range.end - 1] - stamp_s_[range.first];
      spacings += range.size() - 1;
    }
    period_s_ = spacings > 0 ? sum_s / static_cast<double>(spacings) : 0;
  }

  /// False if there are too few rows.
  bool fit() {
    if (period_s_ <= 0) return false;
    set_window();
    if (!scatters_like_delays()) return false;
    if (!estimate_period()) return false;
    find_losses();
    join_caught_up();
    set_window();
    return true;
  }

  EvenTimes times() const {
    EvenTimes result;
    result.time_s = stamp_s_;
    for (const RowRange& range : ranges_) even_out(range, result.time_s);
    result.gaps_after = gaps_in(result.time_s, period_s_);
    const auto [period_s, sigma_s] = fitted_period_s();
    result.rate_hz = 1 / period_s;
    result.rate_sigma_hz = sigma_s / (period_s * period_s);
    return result;
  }

  /// No sample can be later than the longest pause explains.
  bool explains(const std::vector<double>& time_s) const {
    for (std::size_t row = 0; row < stamp_s_.size(); ++row) {
      if (std::abs(stamp_s_[row] - time_s[row]) > longest_pause_s_ + period_s_) return false;
    }
    return true;
  }

 private:
  double spacing_s(std::size_t row) const { return stamp_s_[row] - stamp_s_[row - 1]; }
  // By how much a row is later than evenly after another one.
  double late_s(std::size_t row, std::size_t from) const {
    return stamp_s_[row] - stamp_s_[from] - static_cast<double>(row - from) * period_s_;
  }

  template <class IsBreak>
  Ranges split_at(IsBreak is_break) const {
    Ranges ranges{{0, stamp_s_.size()}};
    for (std::size_t row = 1; row < stamp_s_.size(); ++row) {
      if (!is_break(row)) continue;
      ranges.back().end = row;
      ranges.push_back({row, stamp_s_.size()});
    }
    return ranges;
  }

  // Several times as long as a pause, so that some of its samples came in time.
  void set_window() {
    longest_pause_s_ = 0;
    for (const RowRange& range : ranges_) {
      for (std::size_t row = range.first + 1; row < range.end; ++row) {
        longest_pause_s_ = std::max(longest_pause_s_, spacing_s(row));
      }
    }
    window_ = std::max(
        rules::kMinStampWindow,
        static_cast<std::size_t>(std::ceil(rules::kWindowPauses * longest_pause_s_ / period_s_)));
  }

  bool scatters_like_delays() const {
    std::vector<double> later_s;
    for (const RowRange& range : ranges_) {
      for (std::size_t row = range.first + 1; row < range.end; ++row) {
        later_s.push_back(late_s(row, row - 1));
      }
    }
    return are_balanced(later_s, window_);
  }

  // The least delayed row of each window.
  std::vector<std::size_t> anchors_of(const RowRange& range) const {
    std::vector<std::size_t> anchors;
    for (std::size_t first = range.first; first < range.end; first += window_) {
      const std::size_t end = std::min(first + window_, range.end);
      if (!anchors.empty() && end - first < window_) break;
      std::size_t least = first;
      for (std::size_t row = first + 1; row < end; ++row) {
        if (late_s(row, least) < 0) least = row;
      }
      anchors.push_back(least);
    }
    return anchors;
  }

  // Calls take(from, to) for anchors that follow each other.
  template <class Take>
  void for_each_pair(Take take) const {
    for (const RowRange& range : ranges_) {
      const std::vector<std::size_t> anchors = anchors_of(range);
      for (std::size_t i = 1; i < anchors.size(); ++i) take(anchors[i - 1], anchors[i]);
    }
  }

  // Typical, because samples are lost in some windows.
  bool estimate_period() {
    std::vector<double> periods;
    for_each_pair([&](std::size_t from, std::size_t to) {
      periods.push_back((stamp_s_[to] - stamp_s_[from]) / static_cast<double>(to - from));
    });
    if (periods.size() < rules::kMinWindows) return false;
    period_s_ = median(std::move(periods));
    return period_s_ > 0;
  }

  // Where one window is later than the one before by a sample and more than others are: at the
  // longest pauses between them, as many as explain it.
  void find_losses() {
    std::vector<double> later;
    for_each_pair([&](std::size_t from, std::size_t to) { later.push_back(late_s(to, from)); });
    const double max_s =
        std::max(period_s_ / 2, rules::kLossSigmas * sigma_by_median(std::move(later)));
    std::vector<bool> is_break(stamp_s_.size());
    for (std::size_t i = 1; i < ranges_.size(); ++i) is_break[ranges_[i].first] = true;
    for_each_pair([&](std::size_t from, std::size_t to) {
      std::vector<std::size_t> pauses(to - from);
      std::iota(pauses.begin(), pauses.end(), from + 1);
      double left_s = late_s(to, from);
      if (left_s <= max_s) return;
      std::sort(pauses.begin(), pauses.end(),
                [&](std::size_t a, std::size_t b) { return spacing_s(a) > spacing_s(b); });
      for (const std::size_t row : pauses) {
        if (left_s <= max_s) break;
        is_break[row] = true;
        left_s -= late_s(row, row - 1);
      }
    });
    ranges_ = split_at([&](std::size_t row) { return is_break[row]; });
  }

  // The rows behind a long pause may be those that waited in it.
  void join_caught_up() {
    std::vector<double> time_s = stamp_s_;
    for (const RowRange& range : ranges_) even_out(range, time_s);
    Ranges joined{ranges_.front()};
    for (std::size_t i = 1; i < ranges_.size(); ++i) {
      const std::size_t row = ranges_[i].first;
      if (is_gap(time_s[row] - time_s[row - 1], period_s_)) {
        joined.push_back(ranges_[i]);
      } else {
        joined.back().end = ranges_[i].end;
      }
    }
    ranges_ = std::move(joined);
  }

  void even_out(const RowRange& range, std::vector<double>& time_s) const {
    const std::vector<std::size_t> anchors = anchors_of(range);
    std::size_t next = 0;
    for (std::size_t row = range.first; row < range.end; ++row) {
      while (next < anchors.size() && anchors[next] < row) ++next;
      const std::size_t near = anchors[next == 0 ? 0 : next - 1];
      const auto rows = static_cast<double>(row) - static_cast<double>(near);
      const bool between = next > 0 && next < anchors.size();
      const double period_s = between ? (stamp_s_[anchors[next]] - stamp_s_[near]) /
                                            static_cast<double>(anchors[next] - near)
                                      : period_s_;
      time_s[row] = stamp_s_[near] + rows * period_s;
    }
  }

  // Of a straight line through the anchors of each range: its period and the sigma of that.
  std::pair<double, double> fitted_period_s() const {
    double rows_square = 0;
    double product = 0;
    double late_square = 0;
    double degrees_of_freedom = -1;
    for (const RowRange& range : ranges_) {
      const std::vector<std::size_t> anchors = anchors_of(range);
      const auto count = static_cast<double>(anchors.size());
      double mean_rows = 0;
      double mean_late = 0;
      for (const std::size_t row : anchors) {
        mean_rows += static_cast<double>(row - range.first) / count;
        mean_late += late_s(row, range.first) / count;
      }
      for (const std::size_t row : anchors) {
        const double rows = static_cast<double>(row - range.first) - mean_rows;
        const double late = late_s(row, range.first) - mean_late;
        rows_square += rows * rows;
        product += rows * late;
        late_square += late * late;
      }
      degrees_of_freedom += count - 1;
    }
    const double left = std::max(late_square - product * product / rows_square, 0.0);
    return {period_s_ + product / rows_square,
            std::sqrt(left / std::max(degrees_of_freedom, 1.0) / rows_square)};
  }

  const std::vector<double>& stamp_s_;
  Ranges ranges_;
  double period_s_ = 0;
  double longest_pause_s_ = 0;
  std::size_t window_ = 0;
};

}  // namespace

std::optional<EvenTimes> even_times(const std::vector<double>& time_s) {
  if (time_s.size() < 2) return std::nullopt;
  const std::size_t gaps = gaps_in(time_s, median_spacing_s(time_s));
  if (gaps == 0) return std::nullopt;
  EvenRows rows(time_s);
  if (!rows.fit()) return std::nullopt;
  EvenTimes even = rows.times();
  even.gaps_before = gaps;
  if (even.gaps_after + std::max(even.gaps_after, rules::kMinWindows) > gaps) return std::nullopt;
  if (!rows.explains(even.time_s)) return std::nullopt;
  return even;
}

}  // namespace fogcomp::recording
