#include "recording/reading.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/acquisition/rate_monitor.hpp"
#include "core/acquisition/reading_monitor.hpp"
#include "recording/board_limits.hpp"
#include "recording/decision_rules.hpp"

namespace fogcomp::recording {
namespace {

using fog::Status;

// Times of rows are not multiples of a period: the temperature monitor counts microseconds instead
// of samples.
constexpr std::uint32_t kMonitorPeriodUs = 1;
constexpr double kLongestElapsedS = 3600;  // limit of the monitors' count

// As std::llround(), halves away from zero, without its call: several for each row.
std::int64_t nearest_whole(double value) {
  const auto whole = static_cast<std::int64_t>(value);
  const double rest = value - static_cast<double>(whole);
  return whole + (rest >= 0.5 ? 1 : 0) - (rest <= -0.5 ? 1 : 0);
}

std::uint32_t elapsed_us(double passed_s) {
  return static_cast<std::uint32_t>(nearest_whole(std::min(passed_s, kLongestElapsedS) * 1e6));
}

std::int32_t raw_of(double value, int fractional_bits) {
  const double raw = value * static_cast<double>(std::int64_t{1} << fractional_bits);
  return static_cast<std::int32_t>(
      nearest_whole(std::clamp(raw, double{INT32_MIN}, double{INT32_MAX})));
}

fog::Temperature board_temperature(double degc) {
  return fog::Temperature::from_raw(raw_of(degc, fog::Temperature::fractional_bits));
}

fog::Rate board_rate(double dph) {
  return fog::Rate::from_raw(raw_of(dph, fog::Rate::fractional_bits));
}

bool is_power_on_reading(double degc) {
  return board_temperature(degc) == fog::kPowerOnReading;
}

/// The core's monitor, applied to rows of any length, forwards or backwards in time.
class TemperatureTracker {
 public:
  /// Faults of a reading: none, temperature_invalid, or with it temperature_jump.
  /// (frozen_temperatures() finds frozen ones.)
  Status judge(double time_s, double degc) {
    const fog::Temperature reading = board_temperature(degc);
    if (!fog::is_possible(reading)) return Status::temperature_invalid;
    const double passed_s = any_ ? std::fabs(time_s - judged_s_) : 0;
    believed_ = accepts(reading, time_s, degc, passed_s);
    any_ = true;
    judged_s_ = time_s;
    if (!believed_) return Status::temperature_invalid | Status::temperature_jump;
    has_good_ = true;
    good_s_ = time_s;
    good_degc_ = degc;
    return Status::none;
  }

 private:
  // Passes the reading to the monitor: directly or, if that is a jump, along a straight line.
  bool accepts(fog::Temperature reading, double time_s, double degc, double passed_s) {
    const fog::TemperatureMonitor before = monitor_;
    const Status at_once = monitor_.judge(reading, true, elapsed_us(passed_s));
    if (!has_any(at_once, Status::temperature_jump)) return true;
    if (!can_be_on_line(degc)) return false;
    fog::TemperatureMonitor straight = before;
    const Status seen = follow_line(straight, time_s, degc, passed_s);
    if (has_any(seen, Status::temperature_jump)) return false;
    monitor_ = straight;
    return true;
  }

  // A sensor that repeats 85 degC is in its power-on state, however long.
  bool can_be_on_line(double degc) const {
    return has_good_ && (believed_ || !is_power_on_reading(degc));
  }

  // Simulates the readings since the last row, with the temperature on a straight line from its
  // last good value. The monitor accepts 2 degC per reading, and 1 degC to exactly 85 degC. Steps
  // of 2 s make the former 1 degC/s, the monitor's limit over time; steps of 5 s make the latter 12
  // degC/min, the fastest approach of a chamber to a soak. 200 steps reach any temperature: after a
  // long gap nothing is a jump.
  Status follow_line(fog::TemperatureMonitor& monitor, double time_s, double degc,
                     double passed_s) const {
    const double step_s = is_power_on_reading(degc) ? 5 : 2;
    const int steps = static_cast<int>(std::clamp(std::ceil(passed_s / step_s), 1.0, 200.0));
    const double step_degc = (degc - good_degc_) / std::fabs(time_s - good_s_) * passed_s / steps;
    Status status = Status::none;
    for (int left = steps - 1; left >= 0; --left) {
      status = monitor.judge(board_temperature(degc - step_degc * left), true,
                             elapsed_us(passed_s / steps));
    }
    return status;
  }

  fog::TemperatureMonitor monitor_{kMonitorPeriodUs};
  bool any_ = false;
  double judged_s_ = 0;    // time of the last possible reading
  bool believed_ = false;  // whether it was accepted
  bool has_good_ = false;
  double good_s_ = 0;  // time of the last accepted reading
  double good_degc_ = 0;
};

class RowJudge {
  static constexpr double kAnyRateS = 1;  // crosses the whole range in 0.06 s

 public:
  RowJudge(const Recording& recording, const GyroLimits& limits)
      : time_s_(recording.time_s),
        temperature_degc_(recording.temperature_degc),
        rate_dph_(recording.rate_dph),
        rate_period_us_(elapsed_us(std::clamp(recording.period_s, 1e-6, kAnyRateS))),
        rate_(board_limits(limits, rate_period_us_ * 1e-6), rate_period_us_) {}

  // `first`: whose temperature is believed; `is_start_wrong`: none before it.
  std::vector<RefusedRow> judge(std::size_t first, bool is_start_wrong) {
    const std::vector<Status> before_first = judge_backwards_from(first);
    for (std::size_t row = 0; row < time_s_.size(); ++row) {
      const Status status = row >= first     ? judge_temperature(row)
                            : is_start_wrong ? jump_at(row)
                                             : before_first[row];
      note(row, status | rate_status(row));
    }
    return refused_;
  }

  // The row from which on temperatures are right if those before it are of a sensor that did not
  // measure yet: they jumped once and for all, and are one value or fewer than the jump cost; or 0.
  std::size_t end_of_wrong_start() const { return level_; }

  // First row whose temperature the next row confirms; without one, the first that the board would
  // accept; rows() if every reading is impossible or 85 degC.
  std::size_t first_confirmed() const {
    const std::size_t rows = time_s_.size();
    std::size_t first = rows;
    for (std::size_t row = 0; row < rows; ++row) {
      if (!is_possible(row) || is_power_on_reading(temperature_degc_[row])) continue;
      first = std::min(first, row);
      std::size_t next = row + 1;
      while (next < rows && !is_possible(next)) ++next;
      if (next == rows) break;
      if (are_compatible(row, next)) return row;
    }
    return first;
  }

 private:
  Status judge_in(TemperatureTracker& walk, std::size_t row) const {
    return walk.judge(time_s_[row], temperature_degc_[row]);
  }
  bool is_possible(std::size_t row) const {
    return fog::is_possible(board_temperature(temperature_degc_[row]));
  }

  // One value: what a variable says before it was set is 0, however long, and what a sensor says
  // before it measures lasts no longer than an excursion.
  bool is_unread_until(std::size_t end) const {
    const double said_degc = temperature_degc_[0];
    return (said_degc == 0 || time_s_[end] - time_s_[0] <= rules::kMaxExcursionS) &&
           std::all_of(temperature_degc_.begin(),
                       temperature_degc_.begin() + static_cast<std::ptrdiff_t>(end),
                       [&](double degc) { return degc == said_degc; });
  }

  // Whether one coil can have had these two temperatures.
  bool are_compatible(std::size_t row, std::size_t later) const {
    TemperatureTracker walk;
    return judge_in(walk, row) == Status::none && judge_in(walk, later) == Status::none;
  }

  Status jump_at(std::size_t row) const {
    return is_possible(row) ? Status::temperature_jump : Status::temperature_invalid;
  }

  std::vector<Status> judge_backwards_from(std::size_t first) const {
    std::vector<Status> status(first, Status::none);
    TemperatureTracker walk;
    const bool known = first < time_s_.size();
    if (known) judge_in(walk, first);
    for (std::size_t row = first; row-- > 0;) {
      if (known) status[row] = judge_in(walk, row);
      if (!known && !is_possible(row)) status[row] = Status::temperature_invalid;
    }
    return status;
  }

  // Forwards from the first confirmed row. A new temperature is accepted like on the board, unless
  // the coil cannot have come back from it either.
  Status judge_temperature(std::size_t row) {
    const Status status = judge_in(walk_, row);
    if (has_any(status, Status::temperature_jump)) {
      if (jumping_) return status;
      if (has_returned(row)) {
        refuse_excursion(row);
        return Status::none;
      }
      jumping_ = true;
      left_ = good_;
      jump_ = row;
    } else if (status == Status::none) {
      if (jumping_) {
        excursion_ = are_compatible(row - 1, row);
        if (excursion_ && (jump_ < row - jump_ || is_unread_until(jump_))) level_ = jump_;
      }
      jumping_ = false;
      good_ = row;
    }
    return status;
  }

  // A longer one may be a soak in a recording joined from several.
  bool has_returned(std::size_t row) const {
    if (!excursion_ || time_s_[row] - time_s_[jump_] > rules::kMaxExcursionS) return false;
    const double left_degc = temperature_degc_[left_];
    const double still_away_degc = std::fabs(temperature_degc_[row] - left_degc);
    return still_away_degc < std::fabs(temperature_degc_[jump_] - left_degc) / 2 &&
           are_compatible(left_, row);
  }

  void refuse_excursion(std::size_t end) {
    while (!refused_.empty() && refused_.back().row >= jump_) refused_.pop_back();
    for (std::size_t row = jump_; row < end; ++row) note(row, jump_at(row));
    if (level_ == jump_) level_ = 0;
    walk_ = TemperatureTracker();
    judge_in(walk_, left_);
    judge_in(walk_, end);
    excursion_ = false;
    good_ = end;
  }

  Status rate_status(std::size_t row) {
    const double passed_s = row == 0 ? 0 : time_s_[row] - time_s_[row - 1];
    const std::uint32_t samples = (elapsed_us(passed_s) + rate_period_us_ / 2) / rate_period_us_;
    return rate_.judge(board_rate(rate_dph_[row]), true, std::max(samples, 1U));
  }

  void note(std::size_t row, Status status) {
    const auto refuse = [&](Refusal why) { refused_.push_back({row, why}); };
    if (has_any(status, Status::temperature_jump)) {
      refuse(is_power_on_reading(temperature_degc_[row]) ? Refusal::power_on_temperature
                                                         : Refusal::temperature_jump);
    } else if (has_any(status, Status::temperature_invalid)) {
      refuse(Refusal::impossible_temperature);
    } else if (has_any(status, Status::rate_out_of_range)) {
      refuse(Refusal::rate_beyond_range);
    } else if (has_any(status, Status::rate_jump)) {
      refuse(Refusal::rate_jump);
    }
  }

  const std::vector<double>& time_s_;
  const std::vector<double>& temperature_degc_;
  const std::vector<double>& rate_dph_;
  TemperatureTracker walk_;
  std::size_t good_ = 0;    // row whose temperature was accepted last
  bool jumping_ = false;    // the rows since jump_ are refused
  bool excursion_ = false;  // ... although the board would have accepted them in the end
  std::size_t jump_ = 0;
  std::size_t left_ = 0;   // good row before jump_
  std::size_t level_ = 0;  // first row of the first excursion that has not ended
  std::uint32_t rate_period_us_;
  fog::RateMonitor rate_;
  std::vector<RefusedRow> refused_;
};

}  // namespace

std::vector<RefusedRow> refused_rows(const Recording& recording, const GyroLimits& limits) {
  RowJudge judge(recording, limits);
  std::vector<RefusedRow> refused = judge.judge(judge.first_confirmed(), false);
  const std::size_t start = judge.end_of_wrong_start();
  return start == 0 ? refused : RowJudge(recording, limits).judge(start, true);
}

bool judges_frozen_temperatures(const Recording& recording) {
  return std::max(recording.period_s, recording.temperature_period_s) <= rules::kMaxFrozenSampleS;
}

std::vector<RowRange> frozen_temperatures(const Recording& recording) {
  std::vector<RowRange> ranges;
  if (!judges_frozen_temperatures(recording)) return ranges;
  fog::TemperatureMonitor monitor(kMonitorPeriodUs);
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    const double passed_s = row == 0 ? 0 : recording.time_s[row] - recording.time_s[row - 1];
    if (passed_s > kHoldSeconds) monitor = fog::TemperatureMonitor(kMonitorPeriodUs);
    const Status status = monitor.judge(board_temperature(recording.temperature_degc[row]), true,
                                        elapsed_us(passed_s));
    if (!has_any(status, Status::temperature_frozen)) continue;
    if (ranges.empty() || ranges.back().end != row) ranges.push_back({row, row});
    ranges.back().end = row + 1;
  }
  const auto is_short = [&](RowRange range) {
    return recording.time_s[range.end - 1] - recording.time_s[range.first] < kHoldSeconds;
  };
  ranges.erase(std::remove_if(ranges.begin(), ranges.end(), is_short), ranges.end());
  return ranges;
}

}  // namespace fogcomp::recording
