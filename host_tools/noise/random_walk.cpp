#include "noise/random_walk.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "support/units.hpp"

namespace fogcomp::noise {
namespace {

struct Span {
  double start_s = 0;
  double length_s = 0;
};

Span span_of(const series::Rows& rows, const recording::RowRange& run) {
  const double start_s = rows.time_s[run.first];
  return {start_s, rows.time_s[run.end - 1] - start_s + rows.row_s};
}

double angle_of(Eigen::Index mode) {
  return (static_cast<double>(mode) + 0.5) * kPi;
}

// Amplitude of a mode for a coefficient of 1.
double amplitude(Eigen::Index mode, double length_s) {
  return std::sqrt(2 * length_s / kSecondsPerHour) / angle_of(mode);
}

// Modes of a run whose coefficient has more than kVisibleVariance of the variance with which white
// noise determines it. Too few, and what a walk leaves beyond them looks like an effect.
Eigen::Index visible_modes(const Span& span, double row_s, double relative) {
  constexpr double kVisibleVariance = 0.1;
  const double square = span.length_s / kSecondsPerHour * span.length_s / row_s / kVisibleVariance;
  return static_cast<Eigen::Index>(relative * std::sqrt(square) / kPi);
}

}  // namespace

Eigen::MatrixXf random_walk_modes(const series::Rows& rows, double relative) {
  constexpr double kOfAllRuns = 96;
  constexpr Eigen::Index kMinCount = 8;
  const std::vector<recording::RowRange> runs = rows.runs();
  double all_s = 0;
  for (const recording::RowRange& run : runs) all_s += span_of(rows, run).length_s;
  std::vector<Eigen::Index> counts;
  for (const recording::RowRange& run : runs) {
    const Span span = span_of(rows, run);
    const auto share = static_cast<Eigen::Index>(kOfAllRuns * span.length_s / all_s);
    counts.push_back(
        std::max(kMinCount, std::min(share, visible_modes(span, rows.row_s, relative))));
  }
  Eigen::MatrixXf modes = Eigen::MatrixXf::Zero(
      rows.size(), std::accumulate(counts.begin(), counts.end(), Eigen::Index{0}));
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const recording::RowRange& run = runs[i];
    const Span span = span_of(rows, run);
    for (Eigen::Index k = 0; k < counts[i]; ++k, ++column) {
      const double size = amplitude(k, span.length_s);
      for (std::size_t row = run.first; row < run.end; ++row) {
        modes(static_cast<Eigen::Index>(row), column) = static_cast<float>(
            size * std::sin(angle_of(k) * (rows.time_s[row] - span.start_s) / span.length_s));
      }
    }
  }
  return modes;
}

}  // namespace fogcomp::noise
