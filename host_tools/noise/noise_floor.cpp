#include "noise/noise_floor.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "noise/decision_rules.hpp"
#include "noise/input_rate.hpp"
#include "recording/segments.hpp"
#include "series/complete_rows.hpp"
#include "support/evidence.hpp"
#include "support/least_squares.hpp"
#include "support/statistics.hpp"

namespace fogcomp::noise {
namespace {

constexpr std::size_t kMeans = 3;  // in one difference

std::size_t count_differences(const std::vector<recording::RowRange>& stretches,
                              std::size_t samples) {
  std::size_t count = 0;
  for (const recording::RowRange& stretch : stretches) {
    const std::size_t means = stretch.size() / samples;
    if (means >= kMeans) count += means - kMeans + 1;
  }
  return count;
}

// Second differences of means over `samples` samples, scaled to the noise of one mean.
std::vector<double> scaled_differences(const std::vector<double>& bias,
                                       const std::vector<recording::RowRange>& stretches,
                                       std::size_t samples) {
  constexpr std::size_t kStartsPerMean = 8;
  const std::size_t step = std::max<std::size_t>(1, samples / kStartsPerMean);
  const std::size_t span = kMeans * samples;
  const double scale = 1 / (std::sqrt(6.0) * static_cast<double>(samples));
  std::vector<double> differences;
  std::vector<double> sums(span + 1);  // of the last rows of a stretch, from its first on; a ring
  for (const recording::RowRange& stretch : stretches) {
    double sum = 0;
    std::size_t next = step;  // rows until the next difference, once there are enough
    std::size_t at = 0;
    sums[0] = 0;
    for (std::size_t row = stretch.first; row < stretch.end; ++row) {
      sum += bias[row] - bias[stretch.first];
      at = at < span ? at + 1 : 0;
      sums[at] = sum;
      if (row - stretch.first + 1 < span || ++next < step) continue;
      next = 0;
      const auto before = [&](std::size_t rows) {
        return sums[at >= rows ? at - rows : at + span + 1 - rows];
      };
      const double first = before(2 * samples) - before(span);
      const double second = before(samples) - before(2 * samples);
      const double third = sum - before(samples);
      differences.push_back(scale * (third - 2 * second + first));
    }
  }
  return differences;
}

// Standard deviation about zero of the normal part of `values`.
double robust_deviation(const std::vector<double>& values) {
  constexpr double kVarianceWithin = 0.99389;  // of a normal variable within the cut
  constexpr int kRounds = 10;
  double sigma = sigma_by_median(values);
  // A zero median means that the resolution is coarser than the noise, so that most differences
  // vanish: keep all.
  double cut = sigma > 0 ? rules::kFloorCut * sigma : HUGE_VAL;
  for (int round = 0; round < kRounds; ++round) {
    double sum = 0;
    double count = 0;
    for (const double value : values) {
      if (std::fabs(value) > cut) continue;
      sum += value * value;
      ++count;
    }
    const bool all = cut == HUGE_VAL;
    sigma = std::sqrt(sum / count / (all ? 1 : kVarianceWithin));
    if (all || sigma == 0) break;
    cut = rules::kFloorCut * sigma;
  }
  return sigma;
}

Eigen::Map<const Eigen::VectorXd> as_vector(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

// Removes from the differences the part explained by differences of the columns. Differences beyond
// the cut (flanks of steps, spikes) are not used for the fit.
void project_out_columns(const Eigen::MatrixXd& columns,
                         const std::vector<recording::RowRange>& stretches, std::size_t samples,
                         std::vector<double>& differences) {
  constexpr int kRounds = 4;
  const auto rows = static_cast<Eigen::Index>(differences.size());
  Eigen::MatrixXd basis(rows, columns.cols());
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    const std::vector<double> column(columns.col(k).begin(), columns.col(k).end());
    const std::vector<double> of_column = scaled_differences(column, stretches, samples);
    basis.col(k) = Eigen::Map<const Eigen::VectorXd>(of_column.data(), rows);
  }
  const Eigen::VectorXd whole = Eigen::Map<const Eigen::VectorXd>(differences.data(), rows);
  Eigen::VectorXd left = whole;
  for (int round = 0; round < kRounds; ++round) {
    const double sigma = sigma_by_median({left.begin(), left.end()});
    const double cut = round > 0 && sigma > 0 ? rules::kFloorCut * sigma : HUGE_VAL;
    const Eigen::VectorXd kept = (left.array().abs() <= cut).cast<double>();
    left = whole -
           basis * solve_linear(kept.asDiagonal() * basis, kept.cwiseProduct(whole)).coefficients;
  }
  differences.assign(left.begin(), left.end());
}

}  // namespace

std::optional<double> noise_floor_dph(const recording::Recording& recording, double average_s) {
  const std::vector<recording::RowRange> stretches = recording::unmasked_stretches(recording);
  const std::size_t wanted = series::samples_per_row(recording, average_s);
  std::size_t samples = wanted;
  while (samples > 1 && count_differences(stretches, samples) < kEnoughValues) samples /= 2;
  if (count_differences(stretches, samples) == 0) return std::nullopt;
  const double white = std::sqrt(static_cast<double>(samples) / static_cast<double>(wanted));
  // Without an input rate the rate is the bias: a copy of a long recording takes longer than this.
  std::vector<double> differences =
      recording.input_rate_dph.empty()
          ? scaled_differences(recording.rate_dph, stretches, samples)
          : scaled_differences(recording::bias_dph(recording), stretches, samples);
  const Eigen::MatrixXd columns =
      input_rate_columns(as_vector(recording.input_rate_dph), as_vector(recording.temperature_degc),
                         static_cast<Eigen::Index>(samples));
  const auto count = static_cast<std::size_t>(columns.cols());
  if (count > 0 && recording.rows() > rules::kMeansPerColumn * samples * count) {
    project_out_columns(columns, stretches, samples, differences);
  }
  return white * robust_deviation(differences);
}

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
