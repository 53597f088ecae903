#include "noise/spectral_density.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "support/units.hpp"

namespace fogcomp::noise {
namespace {

constexpr double kPeriods = 8;    // of the frequency in a segment
constexpr double kPerOctave = 4;  // frequencies
// Variance of a mean of half overlapping Hann segments, relative to that of separate ones.
constexpr double kOverlap = 1 + 2.0 / 36;

// e^(-2 pi i periods k / length) under a Hann window, for k = 0 .. length - 1; power 1.
std::vector<std::complex<double>> wave_of(std::size_t length) {
  std::vector<std::complex<double>> wave(length);
  double power = 0;
  for (std::size_t k = 0; k < length; ++k) {
    const double turn = 2 * kPi * (static_cast<double>(k) + 0.5) / static_cast<double>(length);
    const double window = (1 - std::cos(turn)) / 2;
    wave[k] = std::polar(window, -kPeriods * turn);
    power += window * window;
  }
  for (std::complex<double>& one : wave) one /= std::sqrt(power);
  return wave;
}

// |sum of wave and values|^2, the values less their mean.
double power_at(const std::vector<std::complex<double>>& wave, const double* values) {
  double mean = 0;
  for (std::size_t k = 0; k < wave.size(); ++k) mean += values[k];
  mean /= static_cast<double>(wave.size());
  std::complex<double> sum = 0;
  for (std::size_t k = 0; k < wave.size(); ++k) sum += wave[k] * (values[k] - mean);
  return std::norm(sum);
}

}  // namespace

std::vector<SpectralPoint> spectral_density(const std::vector<double>& values,
                                            const std::vector<recording::RowRange>& stretches,
                                            double period_s) {
  std::size_t longest = 0;
  for (const recording::RowRange& stretch : stretches) longest = std::max(longest, stretch.size());
  std::vector<SpectralPoint> points;
  for (double rows = static_cast<double>(longest); rows >= 2 * kPeriods;
       rows /= std::exp2(1 / kPerOctave)) {
    const std::vector<std::complex<double>> wave = wave_of(static_cast<std::size_t>(rows));
    double sum = 0;
    double segments = 0;
    for (const recording::RowRange& stretch : stretches) {
      for (std::size_t at = stretch.first; at + wave.size() <= stretch.first + stretch.size();
           at += (wave.size() + 1) / 2) {
        sum += power_at(wave, &values[at]);
        ++segments;
      }
    }
    const double density = std::sqrt(2 * period_s * sum / segments);
    points.push_back({kPeriods / (static_cast<double>(wave.size()) * period_s), density,
                      density / 2 * std::sqrt(kOverlap / segments)});
  }
  if (points.size() < 3) points.clear();
  return points;
}

}  // namespace fogcomp::noise
