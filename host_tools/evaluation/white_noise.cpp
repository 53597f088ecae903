#include "evaluation/white_noise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fogcomp {

double white_noise_dph_rthz(const Recording& recording) {
  if (recording.rows() < 4) return 0;
  const std::vector<double>& rate = recording.rate_dph;
  std::vector<double> differences;
  differences.reserve(rate.size() - 2);
  for (std::size_t i = 2; i < rate.size(); ++i) {
    differences.push_back(std::abs(rate[i] - 2 * rate[i - 1] + rate[i - 2]));
  }
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  constexpr double kMedianOfNormal = 0.6744897501960817;
  const double sigma = *middle / kMedianOfNormal / std::sqrt(6.0);
  return sigma * std::sqrt(recording.period_s);
}

}  // namespace fogcomp
