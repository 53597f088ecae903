#include "support/periodogram.hpp"

#include <complex>
#include <unsupported/Eigen/FFT>

namespace fogcomp {

std::vector<double> periodogram(const std::vector<double>& values) {
  // Eigen's transform needs two values
  if (values.empty()) return {};
  if (values.size() == 1) return {values[0] * values[0]};
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> spectrum;
  fft.fwd(spectrum, values);
  std::vector<double> powers;
  for (std::size_t k = 0; 2 * k < values.size(); ++k) {
    powers.push_back(std::norm(spectrum[k]) / static_cast<double>(values.size()));
  }
  return powers;
}

}  // namespace fogcomp
