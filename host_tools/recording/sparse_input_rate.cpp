#include "recording/reading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "recording/board_limits.hpp"
#include "recording/decision_rules.hpp"
#include "support/evidence.hpp"
#include "support/median.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

struct RateReading {
  std::size_t row;
  double time_s;
  double value;
};

// The cubic through four readings (Newton's divided differences).
class Cubic {
 public:
  explicit Cubic(const RateReading* readings) {
    for (std::size_t i = 0; i < 4; ++i) time_s_[i] = readings[i].time_s;
    for (std::size_t i = 0; i < 4; ++i) difference_[i] = readings[i].value;
    for (std::size_t order = 1; order < 4; ++order) {
      for (std::size_t i = 3; i >= order; --i) {
        difference_[i] = (difference_[i] - difference_[i - 1]) / (time_s_[i] - time_s_[i - order]);
      }
    }
  }

  double at(double time_s) const {
    double value = difference_[3];
    for (std::size_t i = 3; i-- > 0;) value = difference_[i] + (time_s - time_s_[i]) * value;
    return value;
  }

  // By how much a further reading changes the curve at a time: its error, where the readings are
  // those of a smooth movement.
  double change_by(const RateReading& further, double time_s) const {
    double change = further.value - at(further.time_s);
    for (const double t : time_s_) change *= (time_s - t) / (further.time_s - t);
    return std::abs(change);
  }

 private:
  std::array<double, 4> time_s_;
  std::array<double, 4> difference_;
};

// The curves between two readings.
class Between {
 public:
  // `first`: the reading before, of `readings` that are at most a bridge apart.
  Between(const std::vector<RateReading>& readings, std::ptrdiff_t first)
      : readings_(readings), first_(first) {}

  // Error in the middle of the cubic through the readings from `begin` to begin + 3, from the two
  // beside them; infinite if there are no readings for it.
  double error_of(std::ptrdiff_t begin) const {
    if (begin < 0 || begin + 3 >= size()) return kInfinite;
    const Cubic cubic(&of(begin));
    const double middle_s = (of(first_).time_s + of(first_ + 1).time_s) / 2;
    double error = -1;
    for (const std::ptrdiff_t further : beside(begin)) {
      if (further < 0 || further >= size()) continue;
      error = std::max(error, cubic.change_by(of(further), middle_s));
    }
    return error < 0 ? kInfinite : error;
  }
  double error_of_centre() const { return error_of(first_ - 1); }

  struct Choice {
    std::optional<Cubic> cubic{};
    bool is_unknown = false;  // there are curves, and none is good enough
  };
  // The first curve that is good enough: through the readings around, before, behind.
  Choice choose(double max_error) const {
    Choice choice;
    for (const std::ptrdiff_t begin : {first_ - 1, first_ - 2, first_}) {
      const double error = error_of(begin);
      if (error == kInfinite) continue;
      if (error <= max_error) return {Cubic(&of(begin)), false};
      choice.is_unknown = true;
    }
    return choice;
  }

 private:
  std::ptrdiff_t size() const { return static_cast<std::ptrdiff_t>(readings_.size()); }
  const RateReading& of(std::ptrdiff_t i) const { return readings_[static_cast<std::size_t>(i)]; }
  // Beside a sudden change only readings that are farther from it tell, and one alone may agree by
  // chance: the fifth does where a movement is turned round about the third.
  std::array<std::ptrdiff_t, 2> beside(std::ptrdiff_t begin) const {
    if (begin == first_ - 2) return {begin - 1, begin - 2};
    if (begin == first_) return {begin + 4, begin + 5};
    return {begin - 1, begin + 4};
  }

  const std::vector<RateReading>& readings_;
  std::ptrdiff_t first_;
};

// Readings without a pause that is not bridged.
std::vector<std::vector<RateReading>> bridged(const std::vector<double>& time_s,
                                              const std::vector<double>& column) {
  std::vector<std::vector<RateReading>> all;
  for (std::size_t row = 0; row < column.size(); ++row) {
    if (std::isnan(column[row])) continue;
    if (all.empty() || time_s[row] - all.back().back().time_s > kHoldSeconds) {
      all.emplace_back();
    }
    all.back().push_back({row, time_s[row], column[row]});
  }
  return all;
}

// White noise of a sample, from fourth differences, which no movement has between samples.
double noise_of_sample(const std::vector<double>& rate_dph) {
  std::vector<double> differences;
  for (std::size_t i = 4; i < rate_dph.size(); ++i) {
    const double* const r = &rate_dph[i - 4];
    const double difference = std::abs(r[0] - 4 * r[1] + 6 * r[2] - 4 * r[3] + r[4]);
    if (difference > 0) differences.push_back(difference);
  }
  return sigma_by_median(std::move(differences)) / std::sqrt(70.0);
}

// Error of a curve that the readings have everywhere: their own noise, or a movement that is
// always fast. A curve cannot be asked to be better.
double usual_error(const std::vector<std::vector<RateReading>>& stretches) {
  std::vector<double> errors;
  for (const std::vector<RateReading>& readings : stretches) {
    for (std::size_t i = 0; i + 1 < readings.size(); ++i) {
      const double error = Between(readings, static_cast<std::ptrdiff_t>(i)).error_of_centre();
      if (error < kInfinite) errors.push_back(error);
    }
  }
  return errors.empty() ? kInfinite : median(std::move(errors));
}

void extend(std::vector<Mask>& masks, double from_s, double to_s) {
  if (!masks.empty() && masks.back().to_s == from_s) {
    masks.back().to_s = to_s;
  } else {
    masks.push_back({"", from_s, to_s});
  }
}

}  // namespace

std::vector<Mask> draw_input_rate(const std::vector<double>& time_s,
                                  const std::vector<double>& rate_dph,
                                  std::vector<double>& input_rate) {
  const std::vector<std::vector<RateReading>> stretches = bridged(time_s, input_rate);
  const double noise_dph = noise_of_sample(rate_dph);
  const double usual_dph = usual_error(stretches);
  std::vector<Mask> unknown;
  for (const std::vector<RateReading>& readings : stretches) {
    for (std::size_t i = 0; i + 1 < readings.size(); ++i) {
      const RateReading& before = readings[i];
      const RateReading& after = readings[i + 1];
      if (after.row == before.row + 1) continue;
      const double noise_of_mean =
          noise_dph / std::sqrt(static_cast<double>(after.row - before.row));
      const Between::Choice choice =
          Between(readings, static_cast<std::ptrdiff_t>(i))
              .choose(std::max(noise_of_mean, rules::kMaxUsualErrors * usual_dph));
      if (choice.is_unknown) extend(unknown, before.time_s, after.time_s);
      if (!choice.cubic) continue;
      for (std::size_t row = before.row + 1; row < after.row; ++row) {
        input_rate[row] = choice.cubic->at(time_s[row]);
      }
    }
  }
  return unknown;
}

void mask_unknown_input_rate(Recording& recording, const std::vector<Mask>& unknown,
                             const std::string& which, const std::string& remedy,
                             const ReadWatch& watch) {
  if (unknown.empty()) return;
  watch.say(recording.file,
            format("input_rate_dph: fits and comparisons leave out %.4g s ", length_s(unknown)) +
                which + format(", the first at %.6g s; ", unknown.front().from_s) + remedy);
  recording.masks.insert(recording.masks.end(), unknown.begin(), unknown.end());
}

}  // namespace fogcomp::recording
