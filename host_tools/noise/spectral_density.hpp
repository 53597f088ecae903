#pragma once

#include <vector>

#include "recording/segments.hpp"

namespace fogcomp::noise {

/// One frequency of an amplitude spectral density.
struct SpectralPoint {
  double frequency_hz = 0;
  double density = 0;    ///< one-sided, in the unit of the data per sqrt(Hz)
  double one_sigma = 0;  ///< its uncertainty, from the number of segments
};

/// Amplitude spectral density at frequencies with even logarithms, up to half of the rate of the
/// values. Each frequency has segments of eight of its periods, so that the slow ones are resolved
/// and the fast ones averaged (Troebs and Heinzel, Measurement 39, 2006): Hann window, mean
/// removed, half overlapping. No segment crosses the end of a stretch; O(N) per frequency. Empty
/// where no stretch has eight periods of three frequencies.
std::vector<SpectralPoint> spectral_density(const std::vector<double>& values,
                                            const std::vector<recording::RowRange>& stretches,
                                            double period_s);

}  // namespace fogcomp::noise
