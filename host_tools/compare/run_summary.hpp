#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/temperature_sensitivity.hpp"
#include "noise/allan.hpp"
#include "noise/noise_coefficients.hpp"
#include "recording/recording.hpp"
#include "recording/segments.hpp"

namespace fogcomp::compare {

/// Bias (rate less input rate) over some samples. Standard deviations have n - 1 in the
/// denominator; absent for a single value.
struct BiasSummary {
  double mean_dph = 0;                   ///< of all samples
  std::optional<double> std_dph;         ///< of means over a row: GJB 2426A's bias stability
  std::optional<double> sample_std_dph;  ///< of all samples
};

struct SegmentSummary {
  std::string name;
  recording::SegmentKind kind = recording::SegmentKind::soak;
  BiasSummary bias;
  std::size_t rows = 0;
  double start_s = 0;
  double end_s = 0;       ///< time of the last row
  double duration_s = 0;  ///< including the last row's period
  double temperature_min_degc = 0;
  double temperature_max_degc = 0;
  double temperature_rate_degc_per_min = 0;  ///< mean, from the first row to the last
};

/// Properties of one recording without a model.
struct RunSummary {
  BiasSummary bias;
  double average_s = 0;         ///< length of a row
  std::size_t outliers = 0;     ///< rows excluded from all figures (outlier_rows.hpp)
  recording::Recording blocks;  ///< their means
  std::optional<double> noise_floor_dph;
  std::vector<SegmentSummary> segments;
  double soak_s = 0;  ///< duration of the data of the Allan deviation
  std::vector<noise::AllanPoint> allan;
  noise::NoiseCoefficients noise;
  TemperatureSensitivity sensitivity;
  /// Fraction of the bias's variance over the rows that errors of the input rate explain, 0..1;
  /// nothing if the rate is constant.
  std::optional<double> input_rate_share;

  /// A standard deviation of the bias of these rows without their noise, deg/h (floor_removed()).
  std::optional<double> drift_dph(const BiasSummary& of) const;
};

/// Summary in rows of `average_s`, a whole number of the board's blocks as in fit and compare; in
/// single samples if the recording's period is longer.
RunSummary summarize(const recording::Recording& recording, double average_s);

}  // namespace fogcomp::compare
