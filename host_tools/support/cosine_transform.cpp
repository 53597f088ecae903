#include "support/cosine_transform.hpp"

#include <cmath>
#include <complex>
#include <vector>

#include "support/fourier.hpp"
#include "support/units.hpp"

namespace fogcomp {

// By a Fourier transform of the same length: even rows forward, then odd rows backward (Makhoul, "A
// fast cosine transform in one and two dimensions", IEEE Trans. ASSP 28, 1980). Two columns at a
// time, one as the imaginary part.
Eigen::MatrixXd cosine_transform(const Eigen::Ref<const Eigen::MatrixXd>& columns) {
  const Eigen::Index size = columns.rows();
  Eigen::MatrixXd result(size, columns.cols());
  std::vector<std::complex<double>> turns;
  for (Eigen::Index k = 0; k < size; ++k) {
    const double norm = std::sqrt((k == 0 ? 1.0 : 2.0) / static_cast<double>(size));
    turns.push_back(
        std::polar(norm, -kPi * static_cast<double>(k) / (2 * static_cast<double>(size))));
  }
  std::vector<std::complex<double>> values(static_cast<std::size_t>(size));
  for (Eigen::Index first = 0; first < columns.cols(); first += 2) {
    const Eigen::Index second = std::min(first + 1, columns.cols() - 1);
    for (Eigen::Index i = 0; i < size; ++i) {
      const Eigen::Index place = i % 2 == 0 ? i / 2 : size - 1 - i / 2;
      values[static_cast<std::size_t>(place)] = {columns(i, first), columns(i, second)};
    }
    const std::vector<std::complex<double>> spectrum = fourier(values);
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
