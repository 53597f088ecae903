#include "compare/residual_analysis.hpp"

#include <algorithm>
#include <cmath>

#include "compare/decision_rules.hpp"
#include "noise/autocorrelation.hpp"
#include "noise/input_rate.hpp"
#include "noise/quiet_rows.hpp"
#include "support/evidence.hpp"

namespace fogcomp::compare {
namespace {

constexpr std::size_t kTemperatureBins = 20;
constexpr std::size_t kRateBins = 15;
constexpr std::size_t kTimeBins = 24;
constexpr std::size_t kInputBins = 15;

std::optional<double> excess(const Comparison& comparison) {
  if (!comparison.noise_floor_dph) return std::nullopt;
  const double floor = std::pow(*comparison.noise_floor_dph, 2);
  const double beyond = std::pow(comparison.whole.rms_dph, 2) - floor;
  const std::size_t rows = comparison.size() - comparison.outliers;
  if (beyond <= 2 * floor_uncertainty(rows) * floor) return std::nullopt;
  return beyond;
}

std::vector<recording::RowRange> soak_stretches(const Comparison& comparison) {
  std::vector<recording::RowRange> ranges;
  const std::vector<recording::RowRange> stretches = comparison.rows.stretches();
  for (const Comparison::SegmentError& segment : comparison.segments) {
    if (segment.kind != recording::SegmentKind::soak) continue;
    for (const recording::RowRange& stretch : stretches) {
      const std::size_t first = std::max(segment.rows.first, stretch.first);
      const std::size_t end = std::min(segment.rows.end, stretch.end);
      if (first < end) ranges.push_back({first, end});
    }
  }
  return ranges;
}

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::optional<double> input_rate_share(const Comparison& comparison,
                                       const std::vector<double>& residual_dph) {
  const bool is_varying = std::any_of(
      comparison.inputs.begin(), comparison.inputs.end(),
      [](const Comparison::VaryingInput& one) { return one.input == fog::Input::input_rate; });
  if (!is_varying || comparison.size() < rules::kMinRowsToJudge) return std::nullopt;
  return noise::share_of_input_rate(noise::input_rate_columns(comparison.rows),
                                    vector_of(residual_dph));
}

}  // namespace

double floor_uncertainty(std::size_t rows) {
  constexpr double kFloorError = 0.6;
  return kRareSigmas * kFloorError / std::sqrt(static_cast<double>(rows));
}

std::optional<double> ResidualAnalysis::share_of_excess(const ClassTest& test) const {
  if (!excess_dph2) return std::nullopt;
  return std::min(1.0, test.variance_dph2 / *excess_dph2);
}

ResidualAnalysis analyse_residual(const Comparison& comparison) {
  ResidualAnalysis analysis;
  if (comparison.size() == 0) return analysis;
  ResidualRows rows;
  rows.residual_dph = comparison.bridged(comparison.residuals_dph());
  rows.time_s = comparison.rows.time_s;
  rows.stretches = comparison.rows.stretches();
  rows.noise = noise::noise_of(comparison.rows, vector_of(rows.residual_dph));
  const std::vector<double> degc = comparison.rows.temperatures_degc();
  analysis.excess_dph2 = excess(comparison);
  analysis.offset = test_of_mean(rows);
  analysis.offset_sigma_dph = sigma_of_mean(rows);
  analysis.temperature = dependence_on(degc, rows, kTemperatureBins);
  analysis.rate = dependence_on(comparison.rows.temperature_rates_degc_per_min(), rows, kRateBins);
  analysis.time = dependence_on(rows.time_s, rows, kTimeBins);
  for (const Comparison::VaryingInput& input : comparison.inputs) {
    analysis.inputs.push_back(dependence_on(input.values, rows, kInputBins));
  }
  analysis.input_rate_share = input_rate_share(comparison, rows.residual_dph);
  analysis.history = loop_over(degc, rows, kTemperatureBins);
  for (const std::size_t lag : {1U, 2U, 5U, 10U, 20U, 50U, 100U}) {
    if (lag > rows.residual_dph.size() / 4) break;
    analysis.autocorrelation.push_back(
        {static_cast<double>(lag) * comparison.rows.row_s,
         noise::autocorrelation(rows.residual_dph, rows.stretches, lag)});
  }
  analysis.white_band = 2 / std::sqrt(static_cast<double>(rows.residual_dph.size()));
  const std::vector<recording::RowRange> soaks = soak_stretches(comparison);
  analysis.raw_allan = noise::allan_deviation(comparison.bridged(comparison.measured_dph()), soaks,
                                              comparison.rows.row_s);
  analysis.residual_allan = noise::allan_deviation(rows.residual_dph, soaks, comparison.rows.row_s);
  return analysis;
}

}  // namespace fogcomp::compare
