#include "compare/temperature_sensitivity.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "compare/decision_rules.hpp"
#include "support/decompositions.hpp"
#include "support/units.hpp"

namespace fogcomp::compare {
namespace {

constexpr double kRoomDegc = 20;

struct Soak {
  double temperature_degc;
  double bias_dph;
};

double mean(const std::vector<double>& values, const recording::Segment& segment) {
  double sum = 0;
  for (std::size_t i = segment.rows.first; i < segment.rows.end; ++i) sum += values[i];
  return sum / static_cast<double>(segment.rows.size());
}

SoakSlope compare_soaks(const recording::Recording& rows, const std::vector<double>& bias,
                        const std::vector<recording::Segment>& segments) {
  std::vector<Soak> soaks;
  for (const recording::Segment& segment : segments) {
    if (segment.kind != recording::SegmentKind::soak || segment.rows.size() == 0) continue;
    soaks.push_back({mean(rows.temperature_degc, segment), mean(bias, segment)});
  }
  SoakSlope result;
  if (soaks.empty()) return result;
  const auto from_room = [](const Soak& soak) {
    return std::fabs(soak.temperature_degc - kRoomDegc);
  };
  const Soak reference =
      *std::min_element(soaks.begin(), soaks.end(),
                        [&](const Soak& a, const Soak& b) { return from_room(a) < from_room(b); });
  for (const Soak& soak : soaks) {
    const double distance_degc = std::fabs(soak.temperature_degc - reference.temperature_degc);
    if (distance_degc < rules::kMinRangeDegc) continue;
    const double slope = std::fabs(soak.bias_dph - reference.bias_dph) / distance_degc;
    result.bias_dph_per_degc = std::max(slope, result.bias_dph_per_degc.value_or(0));
    result.reference_degc = reference.temperature_degc;
  }
  return result;
}

// dT/dt of each row: difference over a minute to each side, less at the ends of a stretch.
std::vector<double> temperature_rate_degc_per_min(const recording::Recording& rows) {
  constexpr double kSideS = 60;
  const auto side = static_cast<std::size_t>(std::max(1.0, std::round(kSideS / rows.period_s)));
  std::vector<double> rate(rows.rows(), 0);
  for (const recording::RowRange& stretch : recording::stretches_of(rows, {0, rows.rows()})) {
    for (std::size_t i = stretch.first; i < stretch.end; ++i) {
      const std::size_t first = i - std::min(side, i - stretch.first);
      const std::size_t last = std::min(i + side, stretch.end - 1);
      if (first == last) continue;
      rate[i] = (rows.temperature_degc[last] - rows.temperature_degc[first]) /
                (rows.time_s[last] - rows.time_s[first]) * kSecondsPerMinute;
    }
  }
  return rate;
}

bool has(const std::vector<recording::Segment>& segments, recording::SegmentKind kind) {
  return std::any_of(segments.begin(), segments.end(),
                     [kind](const recording::Segment& segment) { return segment.kind == kind; });
}

// Least squares with a parabola in T and one rate term for each direction that has a ramp.
RateTerms fit_rate_terms(const recording::Recording& rows, const std::vector<double>& bias,
                         const std::vector<recording::Segment>& segments) {
  constexpr double kTemperatureScaleDegc = 50;
  const bool heats = has(segments, recording::SegmentKind::ramp_up);
  const bool cools = has(segments, recording::SegmentKind::ramp_down);
  const auto count = static_cast<Eigen::Index>(rows.rows());
  const Eigen::Index columns = 3 + (heats ? 1 : 0) + (cools ? 1 : 0);
  if (count <= columns || columns == 3) return {};

  const std::vector<double> rate = temperature_rate_degc_per_min(rows);
  Eigen::MatrixXd design(count, columns);
  for (Eigen::Index row = 0; row < count; ++row) {
    const auto at = static_cast<std::size_t>(row);
    const double x = (rows.temperature_degc[at] - kRoomDegc) / kTemperatureScaleDegc;
    design.row(row).head(3) << 1, x, x * x;
    if (heats) design(row, 3) = std::max(rate[at], 0.0);
    if (cools) design(row, columns - 1) = std::min(rate[at], 0.0);
  }
  const Eigen::Map<const Eigen::VectorXd> target(bias.data(), count);
  const Eigen::MatrixXd normal = gram(design);
  const Eigen::MatrixXd inverse = inverse_of_definite(normal);
  const Eigen::VectorXd solution = inverse * (design.transpose() * target);
  const auto term = [&](Eigen::Index column) -> std::optional<double> {
    const double inflation = normal(column, column) * inverse(column, column);
    // a singular matrix gives infinity or NaN
    if (!(inflation >= 0.5 && inflation < rules::kMaxVarianceInflation)) return std::nullopt;
    return solution[column];
  };
  return {heats ? term(3) : std::nullopt, cools ? term(columns - 1) : std::nullopt};
}

struct Branch {
  double sum_dph = 0;
  std::size_t rows = 0;
};

WidestLoop find_widest_loop(const recording::Recording& rows, const std::vector<double>& bias,
                            const std::vector<recording::Segment>& segments) {
  constexpr std::size_t kBins = 20;
  const auto [min, max] =
      std::minmax_element(rows.temperature_degc.begin(), rows.temperature_degc.end());
  const double width_degc = (*max - *min) / kBins;
  if (width_degc * kBins < rules::kMinRangeDegc) return {};
  std::array<std::array<Branch, 2>, kBins> branches{};
  for (const recording::Segment& segment : segments) {
    if (segment.kind == recording::SegmentKind::soak) continue;
    const std::size_t branch = segment.kind == recording::SegmentKind::ramp_up ? 0 : 1;
    for (std::size_t i = segment.rows.first; i < segment.rows.end; ++i) {
      const auto bin = static_cast<std::size_t>((rows.temperature_degc[i] - *min) / width_degc);
      Branch& part = branches[std::min(bin, kBins - 1)][branch];
      part.sum_dph += bias[i];
      ++part.rows;
    }
  }
  WidestLoop result;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const auto& [heating, cooling] = branches[bin];
    if (heating.rows < rules::kMinRowsOnBranch || cooling.rows < rules::kMinRowsOnBranch) continue;
    const double loop_dph = std::fabs(heating.sum_dph / static_cast<double>(heating.rows) -
                                      cooling.sum_dph / static_cast<double>(cooling.rows));
    if (loop_dph <= result.hysteresis_dph.value_or(-1)) continue;
    result.hysteresis_dph = loop_dph;
    result.hysteresis_at_degc = *min + (static_cast<double>(bin) + 0.5) * width_degc;
  }
  return result;
}

}  // namespace

TemperatureSensitivity temperature_sensitivity(const recording::Recording& rows,
                                               const std::vector<recording::Segment>& segments) {
  const std::vector<double> bias = recording::bias_dph(rows);
  return {compare_soaks(rows, bias, segments), fit_rate_terms(rows, bias, segments),
          find_widest_loop(rows, bias, segments)};
}

}  // namespace fogcomp::compare
