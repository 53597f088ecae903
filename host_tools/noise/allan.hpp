#pragma once

#include <cstddef>
#include <vector>

#include "recording/recording.hpp"
#include "recording/segments.hpp"

namespace fogcomp::noise {

/// One averaging time of an Allan deviation.
struct AllanPoint {
  std::size_t samples = 0;  ///< averaged: a power of two
  double tau_s = 0;
  double sigma = 0;      ///< Allan deviation, in the unit of the data
  double one_sigma = 0;  ///< its uncertainty: sigma / sqrt(2 pairs)
  /// Number of independent pairs by the error formula of IEEE Std 952: averages of length tau that
  /// fit, less one, summed over the ranges (n/m - 1).
  double pairs = 0;
  std::size_t ranges = 0;  ///< that are long enough
};

/// Overlapping Allan deviation on octaves, from one sample to the longest time with an error below
/// 50 % (two pairs):
///   sigma^2(m) = sum_i (C[i+2m] - 2 C[i+m] + C[i])^2 / (2 m^2 M),  C = cumulative sum of the data,
/// pooled over `ranges`: sums and counts M are added, so that no average crosses their ends. Exact
/// at every octave (no decimation); O(N) per octave, 8 bytes of memory per sample.
std::vector<AllanPoint> allan_deviation(const std::vector<double>& values,
                                        const std::vector<recording::RowRange>& ranges,
                                        double period_s);

/// The stretches of all soaks: only there a gyro's Allan deviation shows its noise.
std::vector<recording::RowRange> soak_ranges(const recording::Recording& recording,
                                             const std::vector<recording::Segment>& segments);

}  // namespace fogcomp::noise
