#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "recording/decision_rules.hpp"
#include "recording/reading.hpp"
#include "support/evidence.hpp"
#include "support/statistics.hpp"

namespace fogcomp::recording {
namespace {

using Rows = std::vector<std::size_t>;

// Rows for which each value is held, but for the last one.
std::vector<double> held_rows(const std::vector<double>& values) {
  std::vector<double> held;
  std::size_t first = 0;
  for (std::size_t row = 1; row < values.size(); ++row) {
    if (values[row] == values[row - 1]) continue;
    held.push_back(static_cast<double>(row - first));
    first = row;
  }
  return held;
}

// Rows from reading to reading if all changes lie on one grid, and not by chance; else 0. On a
// steady ramp one length follows from the one before.
std::size_t grid_of(const std::vector<double>& held) {
  std::size_t grid = 0;
  int others = 0;
  for (std::size_t i = 1; i < held.size(); ++i) {
    grid = std::gcd(grid, static_cast<std::size_t>(held[i]));
    if (i > 1 && std::abs(held[i] - held[i - 1]) > 1) ++others;
  }
  return std::pow(static_cast<double>(grid), others) * kFalseAlarm > 1 ? grid : 0;
}

// The grid or, without one, `otherwise`.
double rhythm_of(std::size_t grid, double otherwise) {
  return grid > 0 ? static_cast<double>(grid) : otherwise;
}

// Rows that most readings are held for at most, in no rhythm.
double usually_at_most(std::vector<double> held) {
  const auto usual =
      held.end() - 1 - std::lround(kNoticeable * static_cast<double>(held.size() - 1));
  std::nth_element(held.begin(), usual, held.end());
  return *usual;
}

// Rows with a reading: those where the value changes and, as readings that happen to be equal look
// like one that is held for longer than the `typical` one, evenly between. The last one goes on at
// the usual rhythm.
Rows reading_rows(const std::vector<double>& held, double typical, std::size_t rows) {
  Rows readings;
  double first = 0;
  const auto add = [&](double each, double end) {
    for (; first < end - 0.5; first += each) {
      readings.push_back(static_cast<std::size_t>(std::ceil(first - 0.5)));
    }
    first = end;
  };
  for (const double length : held) {
    const double count = typical < 2 ? 1 : std::max(1.0, std::round(length / typical));
    add(length / count, first + length);
  }
  add(first / static_cast<double>(readings.size()), static_cast<double>(rows));
  return readings;
}

// Whether a column holds each reading for two samples or more: not if it changes from sample to
// sample, or hardly ever.
bool are_held(const std::vector<double>& held) {
  return held.size() >= kFewValues && *std::min_element(held.begin() + 1, held.end()) >= 2;
}

// Whether the gyro moves from each reading to the next one rather than with the steps.
bool gyro_moves_between(const Rows& readings, const std::vector<double>& time_s,
                        const std::vector<double>& rate_dph,
                        const std::vector<double>& input_rate) {
  double from_steps = 0;
  double from_lines = 0;
  for (std::size_t i = 0; i + 1 < readings.size(); ++i) {
    const std::size_t before = readings[i];
    const std::size_t after = readings[i + 1];
    const double change = input_rate[after] - input_rate[before];
    for (std::size_t row = before; row < after; ++row) {
      const double part = (time_s[row] - time_s[before]) / (time_s[after] - time_s[before]);
      from_steps += std::abs(rate_dph[row] - input_rate[before]);
      from_lines += std::abs(rate_dph[row] - input_rate[before] - part * change);
    }
  }
  return from_lines < from_steps;
}

// A sensor that is read in each row goes through a movement one step of its resolution after the
// other, at any row.
bool skips_steps(const Rows& readings, const std::vector<double>& column) {
  std::vector<double> changes;
  for (std::size_t i = 1; i < readings.size(); ++i) {
    const double change = std::fabs(column[readings[i]] - column[readings[i - 1]]);
    if (change > 0) changes.push_back(change);
  }
  const double step = *std::min_element(changes.begin(), changes.end());
  const auto skipping = std::count_if(changes.begin(), changes.end(), [&](double change) {
    return change > rules::kMaxSpacing * step;
  });
  return static_cast<double>(skipping) > kNoticeable * static_cast<double>(changes.size());
}

void blank_between(const Rows& readings, std::vector<double>& column) {
  std::vector<double> values(column.size(), std::numeric_limits<double>::quiet_NaN());
  for (const std::size_t row : readings) values[row] = column[row];
  column = std::move(values);
}

}  // namespace

bool are_regular(const std::vector<double>& lengths) {
  const auto count = static_cast<double>(lengths.size());
  const double mean = std::accumulate(lengths.begin(), lengths.end(), 0.0) / count;
  double square = 0;
  for (const double each : lengths) square += (each - mean) * (each - mean);
  const double by_chance = mean * (mean - 1);
  // Those of a normal variable with as uncertain a variance.
  const double degrees_of_freedom = 2 * count / (8 + 1 / by_chance);
  return standard_score(square / count / by_chance * degrees_of_freedom, degrees_of_freedom) <=
         -kPossibleSigmas;
}

Rows repeated_readings(const std::vector<double>& rate_dph) {
  const auto most = static_cast<double>(rate_dph.size()) / rules::kMinRowsPerReading;
  const std::vector<double> held = held_rows(rate_dph);
  if (static_cast<double>(held.size()) > most || !are_regular(held)) return {};
  const Rows readings = reading_rows(held, rhythm_of(grid_of(held), median(held)), rate_dph.size());
  if (static_cast<double>(readings.size()) > most) return {};
  Rows repeats(rate_dph.size() - readings.size());
  auto reading = readings.begin();
  auto repeat = repeats.begin();
  for (std::size_t row = 0; row < rate_dph.size(); ++row) {
    if (reading != readings.end() && *reading == row) {
      ++reading;
    } else {
      *repeat++ = row;
    }
  }
  return repeats;
}

bool blank_held_readings(const std::vector<double>& time_s, const std::vector<double>& rate_dph,
                         std::vector<double>& input_rate) {
  const std::vector<double> held = held_rows(input_rate);
  if (!are_held(held)) return false;
  const Rows readings =
      reading_rows(held, rhythm_of(grid_of(held), median(held)), input_rate.size());
  if (!gyro_moves_between(readings, time_s, rate_dph, input_rate)) return false;
  blank_between(readings, input_rate);
  return true;
}

bool blank_held_temperatures(const std::vector<double>& time_s, std::vector<double>& degc) {
  const std::vector<double> held = held_rows(degc);
  if (!are_held(held)) return false;
  const std::size_t grid = grid_of(held);
  const Rows readings = reading_rows(held, rhythm_of(grid, usually_at_most(held)), degc.size());
  if (grid == 0 && !skips_steps(readings, degc)) return false;
  const double held_s = median_spacing_s(time_s) * static_cast<double>(degc.size()) /
                        static_cast<double>(readings.size());
  if (held_s <= rules::kMaxFrozenSampleS || held_s > rules::kMaxUsualPeriodS) return false;
  blank_between(readings, degc);
  return true;
}

}  // namespace fogcomp::recording
