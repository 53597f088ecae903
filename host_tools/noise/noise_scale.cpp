#include "noise/noise_scale.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "noise/decision_rules.hpp"
#include "support/evidence.hpp"
#include "support/statistics.hpp"

namespace fogcomp::noise {
namespace {

// From simulation: variance of ln of the median distance in a window of n rows, times n, for normal
// noise and Student's t with three degrees of freedom.
constexpr double kSamplingVariance = 2.2;

// Distance of each row from the mean of its neighbours, in units of a full row's noise; 0 at ends
// and gaps. Independent of slopes.
Eigen::VectorXd distances(const series::Rows& rows, const Eigen::VectorXd& residual,
                          const Eigen::VectorXd& counted) {
  Eigen::VectorXd distance = Eigen::VectorXd::Zero(residual.size());
  for (const recording::RowRange& run : rows.runs()) {
    for (std::size_t row = run.first + 1; row + 1 < run.end; ++row) {
      const auto at = static_cast<Eigen::Index>(row);
      const bool all = counted[at - 1] > 0 && counted[at] > 0 && counted[at + 1] > 0;
      if (!all || !rows.follows(row) || !rows.follows(row + 1)) continue;
      const double weight = rows.weights.size() > 0 ? rows.weights[at] : 1;
      distance[at] = (residual[at] - (residual[at - 1] + residual[at + 1]) / 2) * std::sqrt(weight);
    }
  }
  return distance;
}

// Natural logarithm of each window's noise; each window lies in one recording.
struct Windows {
  std::vector<recording::RowRange> ranges;
  std::vector<double> log_sigma;
};

Windows windows_of(const series::Rows& rows, const Eigen::VectorXd& distance) {
  Windows windows;
  for (const recording::RowRange& run : rows.runs()) {
    const std::size_t count = std::max<std::size_t>(1, run.size() / rules::kScaleWindow);
    for (std::size_t i = 0; i < count; ++i) {
      const recording::RowRange range{run.first + i * run.size() / count,
                                      run.first + (i + 1) * run.size() / count};
      const auto first = distance.begin() + static_cast<std::ptrdiff_t>(range.first);
      const double sigma =
          sigma_by_median({first, first + static_cast<std::ptrdiff_t>(range.size())});
      windows.ranges.push_back(range);
      windows.log_sigma.push_back(sigma > 0 ? std::log(sigma) : -HUGE_VAL);
    }
  }
  return windows;
}

// Fraction of a window's difference from the typical one that is real, by empirical Bayes; 0 if the
// windows scatter no more than with equal noise.
double shrinkage_factor(const Windows& windows, double typical) {
  double square = 0;
  double count = 0;
  double sampling = 0;
  for (std::size_t i = 0; i < windows.ranges.size(); ++i) {
    if (!std::isfinite(windows.log_sigma[i])) continue;
    square += std::pow(windows.log_sigma[i] - typical, 2);
    sampling += kSamplingVariance / static_cast<double>(windows.ranges[i].size());
    count += 1;
  }
  if (count < 2) return 0;
  square /= count - 1;
  sampling /= count;
  const double own = square - sampling;
  const double error = sampling * std::sqrt(2 / (count - 1));
  return own > kPossibleSigmas * error ? own / square : 0;
}

}  // namespace

Eigen::VectorXd noise_scale(const series::Rows& rows, const Eigen::VectorXd& residual,
                            const Eigen::VectorXd& counted) {
  const Windows windows = windows_of(rows, distances(rows, residual, counted));
  std::vector<double> known;
  for (const double value : windows.log_sigma) {
    if (std::isfinite(value)) known.push_back(value);
  }
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(rows.size());
  if (known.empty()) return scale;
  const double typical = median(known);
  const double share = shrinkage_factor(windows, typical);
  for (std::size_t i = 0; i < windows.ranges.size(); ++i) {
    if (!std::isfinite(windows.log_sigma[i])) continue;
    series::of_rows(scale, windows.ranges[i])
        .setConstant(std::exp(share * (windows.log_sigma[i] - typical)));
  }
  return scale;
}

}  // namespace fogcomp::noise
