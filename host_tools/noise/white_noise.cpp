#include "noise/white_noise.hpp"

#include <cmath>
#include <vector>

#include "support/median.hpp"

namespace fogcomp::noise {

double white_noise_dph_rthz(const recording::Recording& recording) {
  if (recording.rows() < 4) return 0;
  const std::vector<double>& rate = recording.rate_dph;
  std::vector<double> differences;
  differences.reserve(rate.size() - 2);
  for (std::size_t i = 2; i < rate.size(); ++i) {
    differences.push_back(rate[i] - 2 * rate[i - 1] + rate[i - 2]);
  }
  return sigma_by_median(std::move(differences)) / std::sqrt(6.0) * std::sqrt(recording.period_s);
}

}  // namespace fogcomp::noise
