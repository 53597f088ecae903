#include "noise/noise_floor.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "noise/decision_rules.hpp"
#include "recording/segments.hpp"
#include "series/complete_rows.hpp"
#include "support/median.hpp"

namespace fogcomp::noise {
namespace {

constexpr std::size_t kMeans = 3;  // in one difference

std::size_t count_differences(const std::vector<recording::RowRange>& stretches,
                              std::size_t samples) {
  std::size_t count = 0;
  for (const recording::RowRange& stretch : stretches) {
    const std::size_t means = stretch.size() / samples;
    if (means >= kMeans) count += means - kMeans + 1;
  }
  return count;
}

// Second differences of means over so many samples, scaled to the noise of one mean.
std::vector<double> scaled_differences(const std::vector<double>& bias,
                                       const std::vector<recording::RowRange>& stretches,
                                       std::size_t samples) {
  constexpr std::size_t kStartsPerMean = 8;
  const std::size_t step = std::max<std::size_t>(1, samples / kStartsPerMean);
  const double scale = 1 / (std::sqrt(6.0) * static_cast<double>(samples));
  std::vector<double> differences;
  std::vector<double> sums;
  for (const recording::RowRange& stretch : stretches) {
    sums.clear();
    sums.reserve(stretch.size() + 1);
    sums.push_back(0);
    for (std::size_t i = stretch.first; i < stretch.end; ++i) {
      sums.push_back(sums.back() + (bias[i] - bias[stretch.first]));
    }
    for (std::size_t i = 0; i + kMeans * samples <= stretch.size(); i += step) {
      const double first = sums[i + samples] - sums[i];
      const double second = sums[i + 2 * samples] - sums[i + samples];
      const double third = sums[i + 3 * samples] - sums[i + 2 * samples];
      differences.push_back(scale * (third - 2 * second + first));
    }
  }
  return differences;
}

// Standard deviation about zero of the normal part of `values`.
double robust_deviation(const std::vector<double>& values) {
  constexpr double kVarianceWithin = 0.99389;  // of a normal variable within the cut
  constexpr int kRounds = 10;
  double sigma = sigma_by_median(values);
  // A zero median means steps coarser than the noise, so that most differences vanish: keep all.
  double cut = sigma > 0 ? rules::kFloorCut * sigma : HUGE_VAL;
  for (int round = 0; round < kRounds; ++round) {
    double sum = 0;
    double count = 0;
    for (const double value : values) {
      if (std::fabs(value) > cut) continue;
      sum += value * value;
      ++count;
    }
    const bool all = cut == HUGE_VAL;
    sigma = std::sqrt(sum / count / (all ? 1 : kVarianceWithin));
    if (all || sigma == 0) break;
    cut = rules::kFloorCut * sigma;
  }
  return sigma;
}

}  // namespace

std::optional<double> noise_floor_dph(const recording::Recording& recording, double average_s) {
  const std::vector<recording::RowRange> stretches =
      recording::stretches_of(recording, {0, recording.rows()});
  const std::size_t wanted = series::samples_per_row(recording, average_s);
  std::size_t samples = wanted;
  while (samples > 1 && count_differences(stretches, samples) < rules::kMinFloorDifferences)
    samples /= 2;
  if (count_differences(stretches, samples) == 0) return std::nullopt;
  const double white = std::sqrt(static_cast<double>(samples) / static_cast<double>(wanted));
  return white *
         robust_deviation(scaled_differences(recording::bias_dph(recording), stretches, samples));
}

}  // namespace fogcomp::noise
