#include "cli/info_text.hpp"

#include <algorithm>
#include <cmath>

#include "noise/outlier_rows.hpp"
#include "recording/rate_resolution.hpp"
#include "recording/stream_reader.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::cli {
namespace {

constexpr double kInstabilityToFloor = 0.664;  // sqrt(2 ln 2 / pi)

/// Decimals that show a figure of this size with `digits` digits.
int decimals_for(double size, int digits) {
  if (!(size > 0)) return digits;
  return std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(size))), 0, 12);
}

std::string duration(double seconds) {
  if (seconds < 120) return format("%.4g s", seconds);
  if (seconds < 2 * kSecondsPerHour) return format("%.1f min", seconds / 60);
  return format("%.2f h", seconds / kSecondsPerHour);
}

std::string number_or_dash(const std::optional<double>& value, int decimals) {
  return value ? format("%.*f", decimals, *value) : "-";
}

std::string significant(const std::optional<double>& value) {
  return value ? format("%.*f", decimals_for(std::fabs(*value), 3), *value) : "not shown";
}

std::string overview(const Recording& recording, const RunSummary& summary, int decimals) {
  std::string text = recording.file + "\n  " + counted(recording.rows(), "row");
  if (recording.period_s > 0) {
    const double length_s = recording.time_s.back() - recording.time_s.front();
    text += format(" at %.6g Hz, %s", 1 / recording.period_s,
                   duration(length_s + recording.period_s).c_str());
  }
  const std::size_t gaps = recording.stretch_starts.size() - 1;
  if (gaps > 0) text += ", " + counted(gaps, "gap");
  if (recording.bad_rows > 0) text += ", " + counted(recording.bad_rows, "bad row") + " left out";
  if (recording.refused_rows > 0) {
    text += "\n  " + counted(recording.refused_rows, "row") + " left out by the board's rules";
  }
  const std::string disorder = recording.capture ? describe(*recording.capture) : "";
  if (!disorder.empty()) text += "\n  " + disorder;
  if (recording.rows() > 1 && !rate_resolution(recording).moves()) {
    text += "\n  note: the rate does not move; is the gyro on and connected?";
  }

  text += "\n\nBias (rate less input rate), deg/h\n";
  const auto line = [&](const std::string& label, const std::optional<double>& value) {
    text += format("  %-36s %12s\n", label.c_str(), number_or_dash(value, decimals).c_str());
  };
  const BiasSummary& bias = summary.bias;
  line("mean", bias.mean_dph);
  if (recording.rows() == 1) return text;
  line(format("std of %.4g s means", summary.average_s), bias.std_dph);
  line(format("noise floor of %.4g s means", summary.average_s), summary.noise_floor_dph);
  if (bias.std_dph && summary.noise_floor_dph) {
    const double drift = std::pow(*bias.std_dph, 2) - std::pow(*summary.noise_floor_dph, 2);
    line("drift, sqrt(std^2 - floor^2)", std::sqrt(std::max(0.0, drift)));
  }
  if (summary.outliers > 0)
    text += "  " + outlier_words(summary.outliers, summary.average_s) + "\n";
  return text;
}

std::string segment_table(const RunSummary& summary, int decimals) {
  std::size_t longest = 7;
  for (const SegmentSummary& segment : summary.segments) {
    longest = std::max(longest, segment.name.size());
  }
  const int width = static_cast<int>(longest);
  std::string text = format("\n%-*s %8s %10s %18s %9s %11s %10s\n", width, "Segment", "start",
                            "length", "temperature, degC", "degC/min", "mean, deg/h", "std, deg/h");
  for (const SegmentSummary& segment : summary.segments) {
    text += format("%-*s %6.2f h %10s %8.2f..%8.2f %9.3f %11.*f %10s\n", width,
                   segment.name.c_str(), segment.start_s / kSecondsPerHour,
                   duration(segment.duration_s).c_str(), segment.temperature_min_degc,
                   segment.temperature_max_degc, segment.temperature_rate_degc_per_min, decimals,
                   segment.bias.mean_dph, number_or_dash(segment.bias.std_dph, decimals).c_str());
  }
  return text;
}

std::string allan_table(const RunSummary& summary) {
  if (summary.allan.empty()) {
    return "\nAllan deviation: no soak is long enough; on a ramp it would show drift, not noise.\n";
  }
  std::string text =
      format("\nAllan deviation (overlapping, soaks only: %s)\n", duration(summary.soak_s).c_str());
  text += format("%12s %14s %14s\n", "tau, s", "sigma, deg/h", "+- (1 sigma)");
  for (const AllanPoint& point : summary.allan) {
    const int decimals = decimals_for(point.one_sigma, 2);
    text += format("%12.6g %14.*f %14.*f\n", point.tau_s, decimals, point.sigma, decimals,
                   point.one_sigma);
  }
  return text;
}

std::string coefficient_line(const char* symbol, const char* name, const char* unit,
                             const std::optional<NoiseCoefficient>& coefficient) {
  if (!coefficient) return format("  %s  %-20s not shown by these data\n", symbol, name);
  const int decimals = decimals_for(coefficient->half_width_95, 2);
  return format("  %s  %-20s %.*f +- %.*f %s\n", symbol, name, decimals, coefficient->value,
                decimals, coefficient->half_width_95, unit);
}

/// What the lowest point of the curve still says where no flat part is seen.
std::string instability_bound(const RunSummary& summary) {
  const auto lowest = std::min_element(summary.allan.begin(), summary.allan.end(),
                                       [](const AllanPoint& a, const AllanPoint& b) {
                                         return a.sigma + a.one_sigma < b.sigma + b.one_sigma;
                                       });
  const double bound = (lowest->sigma + 2 * lowest->one_sigma) / kInstabilityToFloor;
  return format("     %-20s below %.*f deg/h (curve at %.6g s, plus 2 sigma, over 0.664)\n", "",
                decimals_for(bound, 2), bound, lowest->tau_s);
}

std::string coefficient_table(const RunSummary& summary) {
  if (summary.allan.empty()) return "";
  const NoiseCoefficients& noise = summary.noise;
  std::string text = "\nNoise coefficients (IEEE Std 952), +- at 95 % confidence\n";
  text += coefficient_line("Q", "quantization", "deg", noise.quantization_deg);
  text += coefficient_line("N", "angle random walk", "deg/sqrt(h)", noise.angle_random_walk_dprh);
  text += coefficient_line("B", "bias instability", "deg/h", noise.bias_instability_dph);
  if (!noise.bias_instability_dph) text += instability_bound(summary);
  text += coefficient_line("K", "rate random walk", "deg/h/sqrt(h)", noise.rate_random_walk_dphrh);
  text += coefficient_line("R", "rate ramp", "deg/h/h", noise.rate_ramp_dphh);
  return text;
}

std::string sensitivity_table(const TemperatureSensitivity& sensitivity) {
  std::string text = "\nSensitivity to temperature\n";
  const auto line = [&](const char* name, const std::optional<double>& value,
                        const std::string& unit) {
    text += format("  %-38s %10s%s\n", name, significant(value).c_str(),
                   value ? (" " + unit).c_str() : "");
  };
  line("bias temperature sensitivity", sensitivity.bias_dph_per_degc,
       format("deg/h/degC (worst soak, from %.0f degC)", sensitivity.reference_degc.value_or(0)));
  line("temperature-rate sensitivity, heating", sensitivity.heating_dph_per_degc_per_min,
       "deg/h/(degC/min)");
  line("temperature-rate sensitivity, cooling", sensitivity.cooling_dph_per_degc_per_min,
       "deg/h/(degC/min)");
  line("hysteresis, widest loop", sensitivity.hysteresis_dph,
       format("deg/h (at %.0f degC)", sensitivity.hysteresis_at_degc.value_or(0)));
  return text;
}

}  // namespace

std::string info_text(const Recording& recording, const RunSummary& summary) {
  const double scatter = summary.bias.std_dph.value_or(std::fabs(summary.bias.mean_dph));
  const int decimals = decimals_for(scatter, 4);
  return overview(recording, summary, decimals) + segment_table(summary, decimals) +
         allan_table(summary) + coefficient_table(summary) + sensitivity_table(summary.sensitivity);
}

}  // namespace fogcomp::cli
