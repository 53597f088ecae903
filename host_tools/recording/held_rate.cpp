#include "recording/held_rate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "recording/decision_rules.hpp"
#include "support/distributions.hpp"
#include "support/evidence.hpp"
#include "support/median.hpp"

namespace fogcomp::recording {
namespace {

std::size_t changes_in(const std::vector<double>& values) {
  std::size_t changes = 0;
  for (std::size_t row = 1; row < values.size(); ++row) {
    if (values[row] != values[row - 1]) ++changes;
  }
  return changes;
}

// Rows for which each value is held.
std::vector<double> held_rows(const std::vector<double>& values) {
  std::vector<double> held;
  std::size_t first = 0;
  for (std::size_t row = 1; row < values.size(); ++row) {
    if (values[row] == values[first]) continue;
    held.push_back(static_cast<double>(row - first));
    first = row;
  }
  return held;
}

// Two readings that happen to be equal look like one that is held for twice as long.
std::vector<double> divided(const std::vector<double>& held) {
  const double typical = median(held);
  std::vector<double> readings;
  for (const double rows : held) {
    const double count = typical < 2 ? 1 : std::max(1.0, std::round(rows / typical));
    for (double i = 0; i < count; ++i) readings.push_back(rows / count);
  }
  return readings;
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

std::vector<std::size_t> repeated_readings(const std::vector<double>& rate_dph) {
  const auto changes = static_cast<double>(changes_in(rate_dph));
  if (changes * rules::kMinRowsPerReading > static_cast<double>(rate_dph.size())) return {};
  const std::vector<double> held = held_rows(rate_dph);
  if (!are_regular(held)) return {};
  const std::vector<double> readings = divided(held);
  const double rows_per_reading =
      static_cast<double>(rate_dph.size()) / static_cast<double>(readings.size() + 1);
  if (rows_per_reading < rules::kMinRowsPerReading) return {};
  std::vector<std::size_t> repeats;
  double next = 0;  // row of the next reading
  std::size_t reading = 0;
  for (std::size_t row = 0; row < rate_dph.size(); ++row) {
    const bool is_reading = static_cast<double>(row) >= next - 0.5;
    if (!is_reading) {
      repeats.push_back(row);
      continue;
    }
    // The last reading goes on at the usual rhythm.
    next += reading < readings.size() ? readings[reading] : rows_per_reading;
    ++reading;
  }
  return repeats;
}

}  // namespace fogcomp::recording
