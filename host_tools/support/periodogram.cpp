#include "support/periodogram.hpp"

#include <complex>
#include <cstdint>
#include <unsupported/Eigen/FFT>

#include "support/units.hpp"

namespace fogcomp {
namespace {

using Spectrum = std::vector<std::complex<double>>;

// Eigen's transform takes a time proportional to the largest prime factor of the number of values.
constexpr std::size_t kMaxPrimeFactor = 50;

bool has_small_factors(std::size_t count) {
  for (std::size_t factor = 2; factor <= kMaxPrimeFactor && factor <= count; ++factor) {
    while (count % factor == 0) count /= factor;
  }
  return count == 1;
}

// e^(-i pi k^2 / size). The square is reduced to a turn while it is exact.
std::complex<double> chirp(std::size_t k, std::size_t size) {
  const std::uint64_t square = static_cast<std::uint64_t>(k) * k % (2 * size);
  return std::polar(1.0, -kPi * static_cast<double>(square) / static_cast<double>(size));
}

// The transform as a convolution with a chirp, whose length can be a power of two, because
// 2 n k = n^2 + k^2 - (k - n)^2 (Bluestein, "A linear filtering approach to the computation of
// discrete Fourier transform", IEEE Trans. Audio Electroacoust. 18, 1970).
Spectrum transform_by_chirp(const std::vector<double>& values) {
  const std::size_t size = values.size();
  std::size_t length = 1;
  while (length < 2 * size - 1) length *= 2;
  Spectrum chirped(length);
  Spectrum filter(length);
  for (std::size_t k = 0; k < size; ++k) {
    const std::complex<double> one = chirp(k, size);
    chirped[k] = values[k] * one;
    filter[k] = std::conj(one);
    filter[(length - k) % length] = std::conj(one);
  }
  Eigen::FFT<double> fft;
  Spectrum spectrum;
  Spectrum spectrum_of_filter;
  fft.fwd(spectrum, chirped);
  fft.fwd(spectrum_of_filter, filter);
  for (std::size_t k = 0; k < length; ++k) spectrum[k] *= spectrum_of_filter[k];
  fft.inv(chirped, spectrum);
  return chirped;  // but for a factor of magnitude 1
}

Spectrum transform(const std::vector<double>& values) {
  if (!has_small_factors(values.size())) return transform_by_chirp(values);
  Eigen::FFT<double> fft;
  Spectrum spectrum;
  fft.fwd(spectrum, values);
  return spectrum;
}

}  // namespace

std::vector<double> periodogram(const std::vector<double>& values) {
  // Eigen's transform needs two values
  if (values.empty()) return {};
  if (values.size() == 1) return {values[0] * values[0]};
  const Spectrum spectrum = transform(values);
  std::vector<double> powers;
  for (std::size_t k = 0; 2 * k < values.size(); ++k) {
    powers.push_back(std::norm(spectrum[k]) / static_cast<double>(values.size()));
  }
  return powers;
}

}  // namespace fogcomp
