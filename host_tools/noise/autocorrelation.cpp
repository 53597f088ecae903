#include "noise/autocorrelation.hpp"

#include <Eigen/Core>
#include <algorithm>

#include "noise/decision_rules.hpp"

namespace fogcomp::noise {
namespace {

std::vector<double> without_mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  const double mean = sum / static_cast<double>(std::max<std::size_t>(1, values.size()));
  std::vector<double> result;
  for (const double value : values) result.push_back(value - mean);
  return result;
}

double mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return sum / static_cast<double>(std::max<std::size_t>(1, values.size()));
}

double correlation(const std::vector<double>& centred_values, double variance,
                   const std::vector<recording::RowRange>& stretches, std::size_t lag) {
  double sum = 0;
  double pairs = 0;
  for (const recording::RowRange& stretch : stretches) {
    if (stretch.size() <= lag) continue;
    const auto count = static_cast<Eigen::Index>(stretch.size() - lag);
    const double* const first = centred_values.data() + stretch.first;
    using Values = Eigen::Map<const Eigen::VectorXd>;
    sum += Values(first, count).dot(Values(first + lag, count));
    pairs += static_cast<double>(count);
  }
  return pairs > 0 && variance > 0 ? sum / pairs / variance : 0;
}

}  // namespace

double autocorrelation(const std::vector<double>& values,
                       const std::vector<recording::RowRange>& stretches, std::size_t lag) {
  const std::vector<double> around = without_mean(values);
  return correlation(around, mean_square(around), stretches, lag);
}

double correlated_values(const std::vector<double>& values,
                         const std::vector<recording::RowRange>& stretches) {
  const std::vector<double> around = without_mean(values);
  const double variance = mean_square(around);
  double together = 1;
  for (std::size_t lag = 1;
       lag <= values.size() / 4 &&
       static_cast<double>(lag) <= rules::kCorrelationWindow * std::max(1.0, together);
       ++lag) {
    together += 2 * correlation(around, variance, stretches, lag);
  }
  return std::max(1.0, together);
}

}  // namespace fogcomp::noise
