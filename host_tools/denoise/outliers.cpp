#include "denoise/outliers.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "denoise/thresholds.hpp"
#include "support/evidence.hpp"

namespace fogcomp::denoise {

std::size_t remove_outliers(fog::Span<double> values, double limit) {
  std::size_t removed = 0;
  for (std::size_t i = 2; i + 1 < values.size; ++i) {
    const double before = values[i] - values[i - 1];
    const double after = values[i] - values[i + 1];
    if ((before > 0) != (after > 0)) continue;
    const double activity =
        std::abs(values[i + 1] - values[i - 1]) + std::abs(values[i - 1] - values[i - 2]);
    if (std::min(std::abs(before), std::abs(after)) <= limit + activity) continue;
    values[i] = (values[i - 1] + values[i + 1]) / 2;
    ++removed;
  }
  return removed;
}

double outlier_limit(fog::Span<const double> values) {
  constexpr std::size_t kMaxPlaces = 65536;
  const std::size_t stride = values.size / kMaxPlaces + 1;
  std::vector<double> differences;
  for (std::size_t i = 1; i < values.size; i += stride) {
    differences.push_back(values[i] - values[i - 1]);
  }
  if (differences.empty()) return 0;
  return kCertainSigmas / std::sqrt(2) * noise_of({differences.data(), differences.size()});
}

}  // namespace fogcomp::denoise
