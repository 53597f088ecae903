#include "recording/reading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "recording/board_limits.hpp"
#include "recording/decision_rules.hpp"
#include "support/evidence.hpp"
#include "support/statistics.hpp"
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

// Readings that are at most a bridge apart.
using Readings = std::vector<RateReading>;

// Error, in the middle between the reading `first` and the next one, of the cubic through those
// from `begin` to begin + 3, from the two beside them; infinite if there are no readings for it.
// Beside a sudden change only readings that are farther from it tell, and one alone may agree by
// chance: the fifth does where a movement is turned round about the third.
double error_of(const Readings& readings, std::ptrdiff_t first, std::ptrdiff_t begin) {
  const auto size = static_cast<std::ptrdiff_t>(readings.size());
  const auto of = [&](std::ptrdiff_t i) { return readings.begin() + i; };
  if (begin < 0 || begin + 3 >= size) return kInfinite;
  const Cubic cubic(&*of(begin));
  const double middle_s = (of(first)->time_s + of(first + 1)->time_s) / 2;
  std::array<std::ptrdiff_t, 2> beside{begin - 1, begin + 4};
  if (begin == first - 2) beside = {begin - 1, begin - 2};
  if (begin == first) beside = {begin + 4, begin + 5};
  double error = -1;
  for (const std::ptrdiff_t further : beside) {
    if (further < 0 || further >= size) continue;
    error = std::max(error, cubic.change_by(*of(further), middle_s));
  }
  return error < 0 ? kInfinite : error;
}

// Readings without a pause that is not bridged.
std::vector<Readings> bridged(const std::vector<double>& time_s,
                              const std::vector<double>& column) {
  std::vector<Readings> all;
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
double usual_error(const std::vector<Readings>& stretches) {
  std::vector<double> errors;
  for (const Readings& readings : stretches) {
    for (std::ptrdiff_t i = 0; i + 1 < static_cast<std::ptrdiff_t>(readings.size()); ++i) {
      const double error = error_of(readings, i, i - 1);
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
  const std::vector<Readings> stretches = bridged(time_s, input_rate);
  const double noise_dph = noise_of_sample(rate_dph);
  const double usual_dph = usual_error(stretches);
  std::vector<Mask> unknown;
  for (const Readings& readings : stretches) {
    for (std::size_t i = 0; i + 1 < readings.size(); ++i) {
      const RateReading& before = readings[i];
      const RateReading& after = readings[i + 1];
      if (after.row == before.row + 1) continue;
      const double noise_of_mean =
          noise_dph / std::sqrt(static_cast<double>(after.row - before.row));
      const double max_error = std::max(noise_of_mean, rules::kMaxUsualErrors * usual_dph);
      const auto first = static_cast<std::ptrdiff_t>(i);
      bool is_unknown = false;  // there are curves, and none is good enough
      // The first one that is: through the readings around, before, behind.
      for (const std::ptrdiff_t begin : {first - 1, first - 2, first}) {
        const double error = error_of(readings, first, begin);
        if (error == kInfinite) continue;
        is_unknown = error > max_error;
        if (is_unknown) continue;
        const Cubic cubic(&readings[static_cast<std::size_t>(begin)]);
        for (std::size_t row = before.row + 1; row < after.row; ++row) {
          input_rate[row] = cubic.at(time_s[row]);
        }
        break;
      }
      if (is_unknown) extend(unknown, before.time_s, after.time_s);
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
