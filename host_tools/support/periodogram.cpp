#include "support/periodogram.hpp"

#include <complex>

#include "support/fourier.hpp"

namespace fogcomp {

std::vector<double> periodogram(const std::vector<double>& values) {
  const std::vector<std::complex<double>> spectrum = fourier({values.begin(), values.end()});
  std::vector<double> powers;
  for (std::size_t k = 0; 2 * k < values.size(); ++k) {
    powers.push_back(std::norm(spectrum[k]) / static_cast<double>(values.size()));
  }
  return powers;
}

}  // namespace fogcomp
