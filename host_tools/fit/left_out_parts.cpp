#include "fit/left_out_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fit/decision_rules.hpp"
#include "noise/autocorrelation.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {
namespace {

// Longest memory of the noise in any significant component.
double noise_memory_s(const noise::NoiseModel& noise) {
  double total = noise.white_variance;
  for (const noise::NoiseModel::Component& component : noise.components)
    total += component.variance;
  double longest = noise.row_s;
  for (const noise::NoiseModel::Component& component : noise.components) {
    if (component.variance >= rules::kMinRemembered * total)
      longest = std::max(longest, component.tau_s);
  }
  return longest;
}

}  // namespace

double stretches_of(const series::Rows& rows, const std::vector<double>& residual,
                    const noise::NoiseModel& noise) {
  const double residual_s = rows.row_s * noise::correlated_values(residual, rows.runs());
  const double memory_s = std::max(noise_memory_s(noise), residual_s);
  const double length_s = static_cast<double>(rows.size()) * rows.row_s;
  return std::clamp(std::floor(length_s / (rules::kMemories * memory_s)), rules::kMinStretches,
                    rules::kMaxStretches);
}

std::vector<Part> parts_of(const series::Rows& rows, double count) {
  constexpr std::size_t kParts = 5;
  std::vector<Part> parts(kParts);
  std::size_t first_part = 0;
  for (const recording::RowRange& run : rows.runs()) {
    const double share = static_cast<double>(run.size()) / static_cast<double>(rows.size());
    const auto wanted = static_cast<std::size_t>(std::max(1.0, std::round(count * share)));
    const std::size_t stretches = std::min(wanted, run.size());
    for (std::size_t i = 0; i < stretches; ++i) {
      parts[(first_part + i) % kParts].push_back(
          {run.first + i * run.size() / stretches, run.first + (i + 1) * run.size() / stretches});
    }
    ++first_part;
  }
  return parts;
}

std::vector<Part> cut_runs(const series::Rows& rows, std::size_t count) {
  std::vector<Part> parts(count);
  for (const recording::RowRange& run : rows.runs()) {
    for (std::size_t i = 0; i < count; ++i) {
      parts[i].push_back(
          {run.first + i * run.size() / count, run.first + (i + 1) * run.size() / count});
    }
  }
  return parts;
}

std::vector<Part> directions_of(const series::Rows& rows) {
  Part heating;
  Part cooling;
  const std::vector<double> rates = rows.temperature_rates_degc_per_min();
  for (std::size_t row = 0; row < rates.size(); ++row) {
    if (rates[row] > rules::kRampDegcPerMin) heating.push_back({row, row + 1});
    if (rates[row] < -rules::kRampDegcPerMin) cooling.push_back({row, row + 1});
  }
  return {heating, cooling};
}

std::vector<Part> temperatures_of(const series::Rows& rows) {
  const std::vector<double> degc = rows.temperatures_degc();
  std::vector<std::size_t> coldest_first(degc.size());
  std::iota(coldest_first.begin(), coldest_first.end(), std::size_t{0});
  std::stable_sort(coldest_first.begin(), coldest_first.end(),
                   [&](std::size_t a, std::size_t b) { return degc[a] < degc[b]; });
  std::vector<Part> thirds(3);
  std::vector<std::size_t> third_of(degc.size());
  for (std::size_t i = 0; i < degc.size(); ++i) {
    third_of[coldest_first[i]] = i * thirds.size() / degc.size();
  }
  for (std::size_t row = 0; row < degc.size(); ++row)
    thirds[third_of[row]].push_back({row, row + 1});
  return thirds;
}

std::string how_of(const std::vector<Part>& parts, const series::Rows& rows) {
  return "on stretches of " + time_text(static_cast<double>(parts[0][0].size()) * rows.row_s) +
         ", a fifth of them left out in turn";
}

}  // namespace fogcomp::fit
