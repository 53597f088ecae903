#include "recording/reading.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "recording/decision_rules.hpp"
#include "recording/row_range.hpp"
#include "recording/segments.hpp"
#include "support/evidence.hpp"
#include "support/statistics.hpp"
#include "support/units.hpp"

namespace fogcomp::recording {
namespace {

constexpr double kBlockS = 1;  // of a board, which is masked as a whole

// A change of the record: rows that differ from the one before, or lie between such rows.
struct Flank {
  RowRange rows;    // the rate is steady up to rows.first - 1, and from rows.end - 1 on
  RowRange around;  // as far as no other flank may reach
  double step_dph = 0;
};

// What the gyro saw over a flank beside the record.
struct Deviation {
  RowRange rows;     // until both agree again
  double angle = 0;  // deg/h x s
  double sigma = 0;
  double step_dph = 0;
};

double median_of(const std::vector<double>& values, RowRange rows) {
  const auto at = [&](std::size_t row) {
    return values.begin() + static_cast<std::ptrdiff_t>(row);
  };
  return median({at(rows.first), at(rows.end)});
}

double sigma_of_changes(const std::vector<double>& values, bool count_none) {
  std::vector<double> changes;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double change = values[i] - values[i - 1];
    if (count_none || change != 0) changes.push_back(change);
  }
  return sigma_by_median(std::move(changes)) / std::sqrt(2.0);
}

class Flanks {
 public:
  explicit Flanks(const Recording& recording)
      : recording_(recording), rate_(recording.input_rate_dph), bias_(bias_dph(recording)) {
    noise_dph_ = sigma_of_changes(bias_, false);
    // The record's own noise makes no flank, nor a change that the gyro's noise hides.
    steady_dph_ = std::max(kCertainSigmas * sigma_of_changes(rate_, true), noise_dph_);
    for (const RowRange& stretch : stretches_of(recording, {0, recording.rows()})) find(stretch);
  }

  // Those of which no part is masked. None without noise to measure them by.
  std::vector<Deviation> deviations() const {
    const std::vector<bool> masked = covered(recording_.masks, recording_.time_s);
    std::vector<Deviation> all;
    for (const Flank& flank : flanks_) {
      if (!(noise_dph_ > 0)) break;
      const Deviation one = deviation_of(flank);
      if (!masked[one.rows.first] && !masked[one.rows.end - 1]) all.push_back(one);
    }
    return all;
  }

  // The first and last rows of movements that are longer than a flank: with jumps of their own.
  const std::vector<std::size_t>& movement_ends() const { return movement_ends_; }

 private:
  std::size_t rows_in(double length_s) const {
    return static_cast<std::size_t>(std::ceil(length_s / recording_.period_s));
  }

  void find(const RowRange& stretch) {
    const std::vector<RowRange> changes = changes_in(stretch);
    const std::size_t reach = rows_in(rules::kFlankReachS);
    for (std::size_t i = 0; i < changes.size(); ++i) {
      const auto [first, end] = std::pair(changes[i].first, changes[i].end);
      if (changes[i].size() > reach) {
        movement_ends_.push_back(first);
        movement_ends_.push_back(end - 1);
        continue;
      }
      const std::size_t from = i > 0 ? (changes[i - 1].end + first) / 2 : stretch.first;
      const std::size_t to =
          i + 1 < changes.size() ? (end + changes[i + 1].first) / 2 : stretch.end;
      const Flank flank{
          changes[i],
          {std::max(from, first > reach ? first - reach : 0), std::min(to, end + reach)},
          rate_[end - 1] - rate_[first - 1]};
      if (is_between_steady_rates(flank)) flanks_.push_back(flank);
    }
  }

  // Rows that differ from the one before, with short pauses.
  std::vector<RowRange> changes_in(const RowRange& stretch) const {
    const std::size_t pause = std::max<std::size_t>(2, rows_in(rules::kFlankPauseS));
    std::vector<RowRange> changes;
    for (std::size_t row = stretch.first + 1; row < stretch.end; ++row) {
      if (std::abs(rate_[row] - rate_[row - 1]) <= steady_dph_) continue;
      if (changes.empty() || row - (changes.back().end - 1) > pause) changes.push_back({row, row});
      changes.back().end = row + 1;
    }
    return changes;
  }

  bool is_between_steady_rates(const Flank& flank) const {
    const std::size_t before = flank.rows.first - flank.around.first;
    const std::size_t after = flank.around.end - flank.rows.end;
    return std::min(before, after) >= 2 * rules::kMinSteadyRows &&
           std::abs(flank.step_dph) >= rules::kMinFlankSteps * steady_dph_;
  }

  // The outer half on either side is taken for steady.
  Deviation deviation_of(const Flank& flank) const {
    const RowRange before{flank.around.first, (flank.around.first + flank.rows.first) / 2};
    const RowRange after{(flank.rows.end + flank.around.end) / 2, flank.around.end};
    const double level_before = median_of(bias_, before);
    const double level_after = median_of(bias_, after);
    const double agrees_dph = kCertainSigmas * noise_dph_;
    Deviation result{{flank.rows.first, flank.rows.end}, 0, 0, flank.step_dph};
    for (std::size_t row = before.end; row < flank.rows.first; ++row) {
      if (std::abs(bias_[row] - level_before) <= agrees_dph) continue;
      result.rows.first = row;
      break;
    }
    for (std::size_t row = flank.rows.end; row < after.first; ++row) {
      if (std::abs(bias_[row] - level_after) > agrees_dph) result.rows.end = row + 1;
    }
    // An error of the scale factor follows the record.
    const double rate_before = rate_[flank.rows.first - 1];
    for (std::size_t row = result.rows.first; row < result.rows.end; ++row) {
      const double part = (rate_[row] - rate_before) / flank.step_dph;
      const double level = level_before + part * (level_after - level_before);
      result.angle += (bias_[row] - level) * recording_.period_s;
    }
    const auto rows = static_cast<double>(result.rows.size());
    const double of_levels =
        1 / static_cast<double>(before.size()) + 1 / static_cast<double>(after.size());
    result.sigma = noise_dph_ * recording_.period_s *
                   std::sqrt(rows + rows * rows / 4 * (kPi / 2) * of_levels);
    return result;
  }

  const Recording& recording_;
  const std::vector<double>& rate_;
  std::vector<double> bias_;
  double noise_dph_ = 0;
  double steady_dph_ = 0;
  std::vector<Flank> flanks_;
  std::vector<std::size_t> movement_ends_;
};

// By which the record is late, s: the median, each flank as important as its step is large.
double delay_s(const std::vector<Deviation>& deviations) {
  std::vector<std::pair<double, double>> delays;
  double all = 0;
  for (const Deviation& one : deviations) {
    delays.emplace_back(one.angle / one.step_dph, std::abs(one.step_dph));
    all += std::abs(one.step_dph);
  }
  std::sort(delays.begin(), delays.end());
  double sum = 0;
  for (const auto& [delay, weight] : delays) {
    sum += weight;
    if (sum >= all / 2) return delay;
  }
  return 0;
}

// Of a delay: whether what it makes of the angles shows beside the noise, and whether it explains
// them. Medians.
struct OneDelay {
  OneDelay(const std::vector<Deviation>& deviations, double delay_s) {
    const auto median_over = [&](auto value_of) {
      std::vector<double> values;
      for (const Deviation& one : deviations) {
        values.push_back(std::abs(value_of(one, delay_s * one.step_dph)));
      }
      return median(std::move(values));
    };
    const auto made = [](const Deviation&, double angle) { return angle; };
    const auto left = [](const Deviation& one, double angle) { return one.angle - angle; };
    const auto in_sigmas = [](auto value_of) {
      return [=](const Deviation& one, double angle) { return value_of(one, angle) / one.sigma; };
    };
    shows = median_over(in_sigmas(made)) > rules::kMaxFlankScatter;
    explains = median_over(in_sigmas(left)) <= rules::kMaxFlankScatter ||
               median_over(left) <= kNoticeable * median_over(made);
  }

  bool shows = false;
  bool explains = false;
};

// Around each flank, and as long around each end of a movement.
std::vector<Mask> masks_around(const std::vector<Deviation>& deviations,
                               const std::vector<std::size_t>& movement_ends,
                               const Recording& recording) {
  const double margin_s = std::max(kBlockS, recording.period_s) / 2 + recording.period_s;
  std::vector<Mask> masks;
  std::vector<double> lengths_s;
  for (const Deviation& one : deviations) {
    masks.push_back({"", recording.time_s[one.rows.first] - margin_s,
                     recording.time_s[one.rows.end - 1] + margin_s});
    lengths_s.push_back(masks.back().to_s - masks.back().from_s);
  }
  const double usual_s = median(std::move(lengths_s));
  for (const std::size_t row : movement_ends) {
    const double time_s = recording.time_s[row];
    masks.push_back({"", time_s - usual_s, time_s + usual_s});
  }
  std::sort(masks.begin(), masks.end(),
            [](const Mask& a, const Mask& b) { return a.from_s < b.from_s; });
  return masks;
}

}  // namespace

UnknownFlanks unknown_flanks(const Recording& recording) {
  UnknownFlanks unknown;
  if (recording.input_rate_dph.empty() || !(recording.period_s > 0)) return unknown;
  const Flanks flanks(recording);
  const std::vector<Deviation> deviations = flanks.deviations();
  if (deviations.size() < rules::kMinCases) return unknown;
  const double late_s = delay_s(deviations);
  const OneDelay delay(deviations, late_s);
  if (delay.explains && !delay.shows) return unknown;
  unknown.masks = masks_around(deviations, flanks.movement_ends(), recording);
  if (!delay.explains) return unknown;
  unknown.delay_s = late_s;
  const double rows_s = recording.period_s * static_cast<double>(recording.rows());
  if (length_s(unknown.masks) > kMost * rows_s) unknown.masks.clear();
  return unknown;
}

}  // namespace fogcomp::recording
