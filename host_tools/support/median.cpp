#include "support/median.hpp"

#include <algorithm>
#include <cmath>

namespace fogcomp {

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double sigma_by_median(std::vector<double> values) {
  constexpr double kSigmaPerMedian = 1.4826022185056018;  // of |normal|
  for (double& value : values) value = std::abs(value);
  return kSigmaPerMedian * median(std::move(values));
}

}  // namespace fogcomp
