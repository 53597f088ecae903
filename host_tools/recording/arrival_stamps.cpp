#include "recording/reading.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "recording/decision_rules.hpp"
#include "recording/row_range.hpp"
#include "support/evidence.hpp"
#include "support/statistics.hpp"

namespace fogcomp::recording {
namespace {

constexpr int kRounds = 5;  // until the counts of lost samples stay

// Spacings of no period: samples are missing, or there before they can have been taken.
std::size_t uneven_in(const std::vector<double>& time_s, double period_s) {
  std::size_t uneven = 0;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    const double spacing_s = time_s[i] - time_s[i - 1];
    if (is_gap(spacing_s, period_s) || spacing_s <= period_s / 2) ++uneven;
  }
  return uneven;
}

// Whether samples of one period are still those of the other one at the end of a window.
bool is_period(double one_s, double other_s) {
  return std::abs(one_s - other_s) * static_cast<double>(kFewValues) <= other_s / 2;
}

// Whether values make up for each other: sums of `window` neighbours scatter less than those of
// independent values, whose variance grows with their number. Variance ratio test (Lo and MacKinlay
// 1988); false where there are too few sums to tell.
bool are_balanced(const std::vector<double>& values, std::size_t window) {
  const auto windows = static_cast<double>(values.size() / window);
  const double mean =
      std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  double square = 0;
  double sum_square = 0;
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    square += (values[i] - mean) * (values[i] - mean);
    sum += values[i] - mean;
    if ((i + 1) % window != 0) continue;
    sum_square += sum * sum;
    sum = 0;
  }
  const double independent =
      static_cast<double>(window) * square / static_cast<double>(values.size());
  return standard_score(sum_square / independent, windows) <= -kPossibleSigmas;
}

/// What spacings say of a clock that samples each `period_s`, above 0, and of which some are lost.
struct Clock {
  Clock(const std::vector<double>& time_s, double period_s) {
    std::vector<double> samples;  // from each row to the next
    double all = 0;
    double off_square = 0;
    for (std::size_t i = 1; i < time_s.size(); ++i) {
      const double spacing_s = time_s[i] - time_s[i - 1];
      if (spacing_s > rules::kMaxDropoutS) continue;
      samples.push_back(std::round(spacing_s / period_s));
      all += samples.back();
      off_square += std::pow(spacing_s / period_s - samples.back(), 2);
    }
    const auto rows = static_cast<double>(samples.size());
    const auto early = static_cast<double>(std::count(samples.begin(), samples.end(), 0.0));
    const auto even = static_cast<double>(std::count(samples.begin(), samples.end(), 1.0));
    is_early = early > rules::kShareWithoutLoss * rows;
    const double window = std::ceil(rules::kWindowPauses * rows / (rows - even));
    // Packets are farther apart than samples within them, which fill less than half of the time.
    const bool has_grid =
        even > kMost * all && std::sqrt(off_square / rows) < rules::kMaxAnchorScatter;
    is_even = has_grid || even == rows ||
              !(are_regular(samples) || are_balanced(samples, static_cast<std::size_t>(window)));
  }
  bool is_early = false;  // rows come before the next sample can have been taken
  bool is_even = true;    // pauses are of samples that are lost: whole periods, few beside samples
                          // that came in time; or neither all alike nor making up for each other
};

/// Rows sampled each `period_s`, in ranges between which samples are lost.
class EvenRows {
 public:
  explicit EvenRows(const std::vector<double>& time_s) : stamp_s_(time_s) {
    std::vector<std::size_t> starts{0};
    for (std::size_t row = 1; row < time_s.size(); ++row) {
      if (spacing_s(row) > rules::kMaxDropoutS) starts.push_back(row);
    }
    ranges_ = ranges_from(starts, time_s.size());
    double sum_s = 0;
    std::size_t spacings = 0;
    for (const RowRange& range : ranges_) {
      sum_s += stamp_s_[range.end - 1] - stamp_s_[range.first];
      spacings += range.size() - 1;
    }
    period_s_ = spacings > 0 ? sum_s / static_cast<double>(spacings) : 0;
  }

  /// False if the times do not tell the period, or are not of this one.
  bool fit(std::optional<double> period_s) {
    if (period_s_ <= 0) return false;
    set_window();
    if (!count_losses(period_s)) return false;
    join_caught_up();
    set_window();
    return true;
  }

  EvenTimes times() const {
    EvenTimes result;
    result.time_s = stamp_s_;
    for (const RowRange& range : ranges_) even_out(range, result.time_s);
    result.gaps_after = uneven_in(result.time_s, period_s_);
    const auto [period_s, sigma_s] = fitted_period_s();
    result.rate_hz = 1 / period_s;
    result.rate_sigma_hz = sigma_s / (period_s * period_s);
    return result;
  }

  /// No sample can be later than the longest pause explains, and those that are lost at another
  /// place between the same anchors.
  bool explains(const std::vector<double>& time_s) const {
    double lost = 0;
    for_each_pair([&](std::size_t from, std::size_t to) {
      lost = std::max(lost, samples_between(from, to) - static_cast<double>(to - from));
    });
    const double max_s = longest_pause_s_ + (1 + lost) * period_s_;
    for (std::size_t row = 0; row < stamp_s_.size(); ++row) {
      if (std::abs(stamp_s_[row] - time_s[row]) > max_s) return false;
    }
    return true;
  }

 private:
  double spacing_s(std::size_t row) const { return stamp_s_[row] - stamp_s_[row - 1]; }
  // By how much a row is later than evenly after another one.
  double late_s(std::size_t row, std::size_t from) const {
    return stamp_s_[row] - stamp_s_[from] - static_cast<double>(row - from) * period_s_;
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
        kFewValues,
        static_cast<std::size_t>(std::ceil(rules::kWindowPauses * longest_pause_s_ / period_s_)));
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

  // Samples between two anchors, lost ones included once they are counted.
  double samples_between(std::size_t from, std::size_t to) const {
    const auto rows = static_cast<double>(to - from);
    if (!is_counted_) return rows;
    return std::max(rows, std::round((stamp_s_[to] - stamp_s_[from]) / period_s_));
  }

  // The period of which the times between anchors are whole multiples; of windows that lost
  // nothing it is the shortest. False if they are none, or if too many windows lost some.
  bool count_losses(std::optional<double> given_s) {
    std::vector<double> periods = periods_between_anchors();
    if (periods.size() < rules::kMinCases) return false;
    const bool has_too_many_rows =
        given_s && period_s_ < *given_s && !is_period(period_s_, *given_s);
    if (has_too_many_rows) return false;
    const auto shortest =
        periods.begin() +
        static_cast<std::ptrdiff_t>(rules::kShareWithoutLoss * static_cast<double>(periods.size()));
    std::nth_element(periods.begin(), shortest, periods.end());
    period_s_ = given_s.value_or(*shortest);
    if (!(period_s_ > 0)) return false;
    is_counted_ = true;
    for (int round = 0; round < kRounds; ++round) period_s_ = median(periods_between_anchors());
    if (given_s && !is_period(period_s_, *given_s)) period_s_ = *given_s;
    return given_s || period_is_told();
  }

  // Windows without losses are many, next to none holds more samples than it had time for, and all
  // are of whole periods.
  bool period_is_told() const {
    std::vector<double> off_s;
    double lost = 0;
    double whole = 0;
    double overfull = 0;
    for_each_pair([&](std::size_t from, std::size_t to) {
      const double samples = samples_between(from, to);
      off_s.push_back(stamp_s_[to] - stamp_s_[from] - samples * period_s_);
      const auto rows = static_cast<double>(to - from);
      lost += samples - rows;
      if (samples > rows) return;
      (off_s.back() < -period_s_ / 2 ? overfull : whole) += 1;
    });
    const auto windows = static_cast<double>(off_s.size());
    return lost <= -std::log(rules::kShareWithoutLoss) * windows &&
           whole >= static_cast<double>(rules::kMinCases) &&
           whole >= rules::kShareWithoutLoss * windows &&
           overfull <= rules::kShareWithoutLoss * whole &&
           sigma_by_median(std::move(off_s)) < rules::kMaxAnchorScatter * period_s_;
  }

  std::vector<double> periods_between_anchors() const {
    std::vector<double> periods;
    for_each_pair([&](std::size_t from, std::size_t to) {
      periods.push_back((stamp_s_[to] - stamp_s_[from]) / samples_between(from, to));
    });
    return periods;
  }

  // The rows behind a long pause may be those that waited in it.
  void join_caught_up() {
    std::vector<double> time_s = stamp_s_;
    for (const RowRange& range : ranges_) even_out(range, time_s);
    std::vector<std::size_t> starts{0};
    for (std::size_t i = 1; i < ranges_.size(); ++i) {
      const std::size_t row = ranges_[i].first;
      if (is_gap(time_s[row] - time_s[row - 1], period_s_)) starts.push_back(row);
    }
    ranges_ = ranges_from(starts, time_s.size());
  }

  void even_out(const RowRange& range, std::vector<double>& time_s) const {
    const std::vector<std::size_t> anchors = anchors_of(range);
    const auto fill = [&](std::size_t first, std::size_t end, std::size_t near, double period_s) {
      for (std::size_t row = first; row < end; ++row) {
        const auto rows = static_cast<double>(row) - static_cast<double>(near);
        time_s[row] = stamp_s_[near] + rows * period_s;
      }
    };
    fill(range.first, anchors.front(), anchors.front(), period_s_);
    fill(anchors.back(), range.end, anchors.back(), period_s_);
    for (std::size_t i = 1; i < anchors.size(); ++i) {
      const std::size_t from = anchors[i - 1];
      const std::size_t to = anchors[i];
      const double period_s = (stamp_s_[to] - stamp_s_[from]) / samples_between(from, to);
      const std::size_t behind = first_behind_loss(from, to, period_s);
      fill(from, behind, from, period_s);
      fill(behind, to, to, period_s);
    }
  }

  // The row after which nothing is lost before the anchor `to`: of those from which on no sample
  // would have arrived before it was taken, the one behind the longest pause.
  std::size_t first_behind_loss(std::size_t from, std::size_t to, double period_s) const {
    if (samples_between(from, to) <= static_cast<double>(to - from)) return to;
    std::size_t behind = to;
    for (std::size_t row = to; row > from; --row) {
      const double taken_s = stamp_s_[to] - static_cast<double>(to - row) * period_s;
      if (taken_s > stamp_s_[row] + period_s / 2) break;
      if (spacing_s(row) > spacing_s(behind)) behind = row;
    }
    return behind;
  }

  // Of a straight line through the anchors of each range, and of its parts between which the count
  // of lost samples may be wrong: its period and the sigma of that.
  std::pair<double, double> fitted_period_s() const {
    double square = 0;
    double product = 0;
    double late_square = 0;
    double degrees_of_freedom = -1;
    std::vector<std::pair<double, double>> points;  // samples and lateness since the first one
    const auto end_line = [&] {
      const auto count = static_cast<double>(points.size());
      double samples = 0;
      double late_s = 0;
      for (const auto& [x, y] : points) {
        samples += x;
        late_s += y;
      }
      for (const auto& [x, y] : points) {
        square += std::pow(x - samples / count, 2);
        product += (x - samples / count) * (y - late_s / count);
        late_square += std::pow(y - late_s / count, 2);
      }
      degrees_of_freedom += count - 1;
    };
    for (const RowRange& range : ranges_) {
      const std::vector<std::size_t> anchors = anchors_of(range);
      points = {{0, 0}};
      for (std::size_t i = 1; i < anchors.size(); ++i) {
        const double between = samples_between(anchors[i - 1], anchors[i]);
        const double off_s = stamp_s_[anchors[i]] - stamp_s_[anchors[i - 1]] - between * period_s_;
        if (std::abs(off_s) > period_s_ / 4) {
          end_line();
          points = {{0, 0}};
          continue;
        }
        points.emplace_back(points.back().first + between, points.back().second + off_s);
      }
      end_line();
    }
    const double left = std::max(late_square - product * product / square, 0.0);
    const double variance = left / std::max(degrees_of_freedom, 1.0) + rounding_variance();
    return {period_s_ + product / square, std::sqrt(variance / square)};
  }

  // Of stamps that agree by their rounding: the clock's step is no longer than the shortest time
  // between two of them.
  double rounding_variance() const {
    double step_s = std::numeric_limits<double>::infinity();
    for (std::size_t row = 1; row < stamp_s_.size(); ++row) {
      if (spacing_s(row) > 0) step_s = std::min(step_s, spacing_s(row));
    }
    return step_s * step_s / 12;
  }

  const std::vector<double>& stamp_s_;
  std::vector<RowRange> ranges_;
  double period_s_ = 0;
  double longest_pause_s_ = 0;
  std::size_t window_ = 0;
  bool is_counted_ = false;  // whether samples that are lost between anchors are known
};

}  // namespace

std::optional<std::vector<double>> counted_times(const std::vector<double>& stamp_s,
                                                 double rate_hz) {
  const double period_s = 1 / rate_hz;
  double step_s = std::numeric_limits<double>::infinity();
  std::size_t second = 0;  // row with the second time
  std::size_t times = 1;
  std::size_t losses = 0;
  for (std::size_t row = 1; row < stamp_s.size(); ++row) {
    const double spacing_s = stamp_s[row] - stamp_s[row - 1];
    if (spacing_s <= 0) continue;
    step_s = std::min(step_s, spacing_s);
    if (second == 0) second = row;
    ++times;
  }
  if (second == 0) return std::nullopt;
  std::vector<double> time_s(stamp_s.size());
  double next_s = stamp_s[second] - static_cast<double>(second) * period_s;
  for (std::size_t row = 0; row < stamp_s.size(); ++row) {
    const double behind = (stamp_s[row] - next_s) / period_s;
    if (behind > 1) {
      next_s += std::floor(behind) * period_s;
      ++losses;
    }
    if (next_s > stamp_s[row] + step_s + period_s) return std::nullopt;
    time_s[row] = next_s;
    next_s = time_s[row] + period_s;
  }
  if (2 * losses > times) return std::nullopt;
  return time_s;
}

std::optional<EvenTimes> even_times(const std::vector<double>& time_s,
                                    const std::optional<double>& rate_hz) {
  if (time_s.size() < rules::kMinCases * kFewValues) return std::nullopt;
  const double spacing_s = median_spacing_s(time_s);
  const std::size_t uneven = uneven_in(time_s, spacing_s);
  if (uneven == 0) return std::nullopt;
  bool may_be_clock = spacing_s > 0 && (!rate_hz || is_period(spacing_s, 1 / *rate_hz));
  if (may_be_clock) {
    const Clock clock(time_s, spacing_s);
    may_be_clock = !clock.is_early;
    if (may_be_clock && clock.is_even) return std::nullopt;
  }
  EvenTimes even;
  EvenRows rows(time_s);
  if (rows.fit(rate_hz ? std::optional(1 / *rate_hz) : std::nullopt)) {
    even = rows.times();
    even.is_known = rate_hz || rows.explains(even.time_s);
    const std::size_t least = std::max(even.gaps_after, rules::kMinCases);
    if (even.is_known && may_be_clock && even.gaps_after + least > uneven) return std::nullopt;
  }
  even.uneven_before = uneven;
  return even;
}

}  // namespace fogcomp::recording
