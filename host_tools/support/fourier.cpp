#include "support/fourier.hpp"

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
Spectrum transform_by_chirp(const Spectrum& values) {
  const std::size_t size = values.size();
  std::size_t length = 1;
  while (length < 2 * size - 1) length *= 2;
  Spectrum ones(size);
  Spectrum chirped(length);
  Spectrum filter(length);
  for (std::size_t k = 0; k < size; ++k) {
    ones[k] = chirp(k, size);
    chirped[k] = values[k] * ones[k];
    filter[k] = std::conj(ones[k]);
    filter[(length - k) % length] = std::conj(ones[k]);
  }
  Eigen::FFT<double> fft;
  Spectrum spectrum;
  Spectrum spectrum_of_filter;
  fft.fwd(spectrum, chirped);
  fft.fwd(spectrum_of_filter, filter);
  for (std::size_t k = 0; k < length; ++k) spectrum[k] *= spectrum_of_filter[k];
  fft.inv(chirped, spectrum);
  chirped.resize(size);
  for (std::size_t k = 0; k < size; ++k) chirped[k] *= ones[k];
  return chirped;
}

}  // namespace

std::vector<std::complex<double>> fourier(const std::vector<std::complex<double>>& values) {
  if (values.size() < 2) return values;  // Eigen's transform needs two values
  if (!has_small_factors(values.size())) return transform_by_chirp(values);
  Eigen::FFT<double> fft;
  Spectrum spectrum;
  fft.fwd(spectrum, values);
  return spectrum;
}

}  // namespace fogcomp
