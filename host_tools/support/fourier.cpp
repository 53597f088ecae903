#include "support/fourier.hpp"

#include <cmath>
#include <complex>
#include <cstdint>
#include <map>
#include <optional>
#include <unsupported/Eigen/FFT>
#include <vector>

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

// Two, three and five have transforms of their own.
std::size_t fast_length_from(std::size_t count) {
  for (;; ++count) {
    std::size_t rest = count;
    for (const std::size_t factor : {2U, 3U, 5U}) {
      while (rest % factor == 0) rest /= factor;
    }
    if (rest == 1) return count;
  }
}

// The transform as a convolution with a chirp, whose length is free, because
// 2 n k = n^2 + k^2 - (k - n)^2 (Bluestein, "A linear filtering approach to the computation of
// discrete Fourier transform", IEEE Trans. Audio Electroacoust. 18, 1970).
class ChirpTransform {
 public:
  explicit ChirpTransform(std::size_t size) : ones_(size) {
    const std::size_t length = fast_length_from(2 * size - 1);
    Spectrum filter(length);
    for (std::size_t k = 0; k < size; ++k) {
      ones_[k] = chirp(k, size);
      filter[k] = std::conj(ones_[k]);
      filter[(length - k) % length] = std::conj(ones_[k]);
    }
    fft_.fwd(spectrum_of_filter_, filter);
  }

  void operator()(const Spectrum& values, Spectrum& transformed) {
    chirped_.assign(spectrum_of_filter_.size(), 0);
    for (std::size_t k = 0; k < values.size(); ++k) chirped_[k] = values[k] * ones_[k];
    fft_.fwd(spectrum_, chirped_);
    for (std::size_t k = 0; k < spectrum_.size(); ++k) spectrum_[k] *= spectrum_of_filter_[k];
    fft_.inv(chirped_, spectrum_);
    transformed.resize(values.size());
    for (std::size_t k = 0; k < values.size(); ++k) transformed[k] = chirped_[k] * ones_[k];
  }

 private:
  Spectrum ones_;
  Spectrum spectrum_of_filter_;
  Spectrum chirped_;
  Spectrum spectrum_;
  Eigen::FFT<double> fft_;
};

// Transforms of some length. What depends on the length alone is computed once: half of the time of
// a transform, and fits of one recording take hundreds of one length.
class Transform {
 public:
  explicit Transform(std::size_t size) {
    if (!has_small_factors(size)) chirped_.emplace(size);
    for (std::size_t k = 0; k < size; ++k) {
      const double norm = std::sqrt((k == 0 ? 1.0 : 2.0) / static_cast<double>(size));
      turns_.push_back(
          std::polar(norm, -kPi * static_cast<double>(k) / (2 * static_cast<double>(size))));
    }
  }

  /// Valid until the next one.
  const Spectrum& operator()(const Spectrum& values) {
    if (chirped_) {
      (*chirped_)(values, spectrum_);
    } else {
      fft_.fwd(spectrum_, values);
    }
    return spectrum_;
  }
  /// Of the cosine transform, in its norm.
  const Spectrum& turns() const { return turns_; }

 private:
  std::optional<ChirpTransform> chirped_;
  Eigen::FFT<double> fft_;
  Spectrum turns_;
  Spectrum spectrum_;
};

// Of two values or more, as Eigen's transform needs them.
Transform& transform_of(std::size_t size) {
  constexpr std::size_t kMaxLengths = 4;  // that a fit has by turns
  thread_local std::map<std::size_t, Transform> known;
  if (known.size() >= kMaxLengths && known.count(size) == 0) known.clear();
  return known.try_emplace(size, size).first->second;
}

}  // namespace

std::vector<std::complex<double>> fourier(const std::vector<std::complex<double>>& values) {
  return values.size() < 2 ? values : transform_of(values.size())(values);
}

std::vector<double> periodogram(const std::vector<double>& values) {
  const std::vector<std::complex<double>> spectrum = fourier({values.begin(), values.end()});
  std::vector<double> powers;
  for (std::size_t k = 0; 2 * k < values.size(); ++k) {
    powers.push_back(std::norm(spectrum[k]) / static_cast<double>(values.size()));
  }
  return powers;
}

// By a Fourier transform of the same length: even rows forward, then odd rows backward (Makhoul, "A
// fast cosine transform in one and two dimensions", IEEE Trans. ASSP 28, 1980). Two columns at a
// time, one as the imaginary part.
Eigen::MatrixXd cosine_transform(const Eigen::Ref<const Eigen::MatrixXd>& columns) {
  const Eigen::Index size = columns.rows();
  if (size < 2) return columns;
  Eigen::MatrixXd result(size, columns.cols());
  Transform& transform = transform_of(static_cast<std::size_t>(size));
  const Spectrum& turns = transform.turns();
  std::vector<std::complex<double>> values(static_cast<std::size_t>(size));
  for (Eigen::Index first = 0; first < columns.cols(); first += 2) {
    const Eigen::Index second = std::min(first + 1, columns.cols() - 1);
    for (Eigen::Index i = 0; i < size; ++i) {
      const Eigen::Index place = i % 2 == 0 ? i / 2 : size - 1 - i / 2;
      values[static_cast<std::size_t>(place)] = {columns(i, first), columns(i, second)};
    }
    const Spectrum& spectrum = transform(values);
    for (Eigen::Index k = 0; k < size; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const std::complex<double> mirrored =
          std::conj(spectrum[static_cast<std::size_t>((size - k) % size)]);
      const std::complex<double> of_first = 0.5 * (spectrum[at] + mirrored);
      const std::complex<double> of_second =
          std::complex<double>(0, -0.5) * (spectrum[at] - mirrored);
      result(k, first) = (turns[at] * of_first).real();
      result(k, second) = (turns[at] * of_second).real();
    }
  }
  return result;
}

}  // namespace fogcomp
