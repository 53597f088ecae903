#include "recording/table_flanks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "recording/decision_rules.hpp"
#include "recording/row_range.hpp"
#include "recording/segments.hpp"
#include "support/median.hpp"
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
    steady_dph_ = std::max(rules::kSteadySigmas * sigma_of_changes(rate_, true), noise_dph_);
    for (const RowRange& stretch : stretches_of(recording, {0, recording.rows()})) find(stretch);
  }

  // None without noise to measure them by.
  std::vector<Deviation> deviations() const {
    std::vector<Deviation> all;
    if (!(noise_dph_ > 0)) return all;
    for (const Flank& flank : flanks_) all.push_back(deviation_of(flank));
    return all;
  }

 private:
  std::size_t rows_in(double length_s) const {
    return static_cast<std::size_t>(std::ceil(length_s / recording_.period_s));
  }

  void find(const RowRange& stretch) {
    const std::size_t begin = flanks_.size();
    const std::size_t pause = std::max<std::size_t>(2, rows_in(rules::kFlankPauseS));
    std::size_t last = 0;
    for (std::size_t row = stretch.first + 1; row < stretch.end; ++row) {
      if (std::abs(rate_[row] - rate_[row - 1]) <= steady_dph_) continue;
      if (last == 0 || row - last > pause) flanks_.push_back({{row, row + 1}, {}, 0});
      flanks_.back().rows.end = row + 1;
      last = row;
    }
    const std::size_t reach = rows_in(rules::kFlankReachS);
    for (std::size_t i = begin; i < flanks_.size(); ++i) {
      Flank& flank = flanks_[i];
      const auto [first, end] = std::pair(flank.rows.first, flank.rows.end);
      const std::size_t from = i > begin ? (flanks_[i - 1].rows.end + first) / 2 : stretch.first;
      const std::size_t to =
          i + 1 < flanks_.size() ? (end + flanks_[i + 1].rows.first) / 2 : stretch.end;
      flank.around = {std::max(from, first > reach ? first - reach : 0), std::min(to, end + reach)};
      flank.step_dph = rate_[end - 1] - rate_[first - 1];
    }
    flanks_.erase(
        std::remove_if(flanks_.begin() + static_cast<std::ptrdiff_t>(begin), flanks_.end(),
                       [&](const Flank& flank) { return is_no_flank(flank); }),
        flanks_.end());
  }

  // A movement for itself, or one between rates that are not held.
  bool is_no_flank(const Flank& flank) const {
    const std::size_t before = flank.rows.first - flank.around.first;
    const std::size_t after = flank.around.end - flank.rows.end;
    return flank.rows.size() > rows_in(rules::kFlankReachS) ||
           std::min(before, after) < 2 * rules::kMinSteadyRows ||
           std::abs(flank.step_dph) < rules::kMinFlankSteps * steady_dph_;
  }

  // The outer half on either side is taken for steady.
  Deviation deviation_of(const Flank& flank) const {
    const RowRange before{flank.around.first, (flank.around.first + flank.rows.first) / 2};
    const RowRange after{(flank.rows.end + flank.around.end) / 2, flank.around.end};
    const double level_before = median_of(bias_, before);
    const double level_after = median_of(bias_, after);
    const double agrees_dph = rules::kFlankSigmas * noise_dph_;
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

bool are_of_one_delay(const std::vector<Deviation>& deviations) {
  const double delay = delay_s(deviations);
  std::vector<double> of_delay;
  std::vector<double> scatter;
  std::vector<double> in_sigmas;
  for (const Deviation& one : deviations) {
    of_delay.push_back(std::abs(delay * one.step_dph));
    scatter.push_back(std::abs(one.angle - delay * one.step_dph));
    in_sigmas.push_back(scatter.back() / one.sigma);
  }
  return median(std::move(in_sigmas)) <= rules::kMaxFlankScatter ||
         median(std::move(scatter)) <= rules::kMaxScatterOfDelay * median(std::move(of_delay));
}

}  // namespace

UnknownFlanks unknown_flanks(const Recording& recording) {
  UnknownFlanks unknown;
  if (recording.input_rate_dph.empty() || !(recording.period_s > 0)) return unknown;
  const std::vector<Deviation> all = Flanks(recording).deviations();
  const std::vector<bool> masked = covered(recording.masks, recording.time_s);
  std::vector<Deviation> deviations;
  for (const Deviation& one : all) {
    if (!masked[one.rows.first] && !masked[one.rows.end - 1]) deviations.push_back(one);
  }
  if (deviations.size() < rules::kMinFlanks || are_of_one_delay(deviations)) return unknown;
  unknown.flanks = deviations.size();
  const double margin_s = std::max(kBlockS, recording.period_s) / 2 + recording.period_s;
  for (const Deviation& one : deviations) {
    const double from_s = recording.time_s[one.rows.first] - margin_s;
    const double to_s = recording.time_s[one.rows.end - 1] + margin_s;
    unknown.masks.push_back({"", from_s, to_s});
    unknown.length_s += to_s - from_s;
  }
  return unknown;
}

}  // namespace fogcomp::recording
