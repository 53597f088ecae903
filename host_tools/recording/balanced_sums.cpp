#include "recording/balanced_sums.hpp"

#include <numeric>
#include <utility>

#include "recording/decision_rules.hpp"
#include "support/median.hpp"

namespace fogcomp::recording {

bool are_balanced(const std::vector<double>& values, std::size_t window) {
  if (values.size() < rules::kMinWindows * window) return false;
  const double mean =
      std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  double square = 0;
  double sum = 0;
  std::vector<double> sums;
  for (std::size_t i = 0; i < values.size(); ++i) {
    square += (values[i] - mean) * (values[i] - mean);
    sum += values[i] - mean;
    if ((i + 1) % window == 0) sums.push_back(std::exchange(sum, 0));
  }
  // Robust: samples may be lost besides.
  const double typical = median(sums);
  for (double& each : sums) each -= typical;
  const double sigma = sigma_by_median(std::move(sums));
  const double independent =
      static_cast<double>(window) * square / static_cast<double>(values.size());
  return sigma * sigma <= rules::kMaxBalancedScatter * independent;
}

}  // namespace fogcomp::recording
