#include "noise/random_walk.hpp"

#include <algorithm>
#include <cmath>

#include "support/units.hpp"

namespace fogcomp::noise {

Eigen::MatrixXd random_walk_modes(const series::Rows& rows) {
  // The 24th mode of a run has 1/47 of the first one's size: far below white noise.
  constexpr Eigen::Index kStrongest = 24;
  constexpr Eigen::Index kOfAllRuns = 96;
  constexpr Eigen::Index kMinCount = 8;
  const std::vector<recording::RowRange> runs = rows.runs();
  const auto count = static_cast<Eigen::Index>(runs.size());
  const Eigen::Index each =
      std::clamp(kOfAllRuns / std::max<Eigen::Index>(1, count), kMinCount, kStrongest);
  Eigen::MatrixXd modes = Eigen::MatrixXd::Zero(rows.size(), each * count);
  Eigen::Index column = 0;
  for (const recording::RowRange& run : runs) {
    const double start_s = rows.time_s[run.first];
    const double length_s = rows.time_s[run.end - 1] - start_s + rows.row_s;
    for (Eigen::Index k = 0; k < each; ++k, ++column) {
      const double angle = (static_cast<double>(k) + 0.5) * kPi;
      const double size = std::sqrt(2 * length_s / kSecondsPerHour) / angle;
      for (std::size_t row = run.first; row < run.end; ++row) {
        modes(static_cast<Eigen::Index>(row), column) =
            size * std::sin(angle * (rows.time_s[row] - start_s) / length_s);
      }
    }
  }
  return modes;
}

}  // namespace fogcomp::noise
