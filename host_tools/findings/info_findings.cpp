#include "findings/findings.hpp"

#include <algorithm>
#include <cmath>

#include "compare/comparison.hpp"
#include "findings/run_plots.hpp"
#include "findings/text.hpp"
#include "noise/outlier_rows.hpp"
#include "recording/recording.hpp"
#include "recording/segments.hpp"
#include "recording/stream_reader.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::findings {
namespace {

struct Finding {
  Text found;
  Next next;
};

bool is_turned(const recording::Recording& recording) {
  return !recording.input_rate_dph.empty() && compare::varies(recording.input_rate_dph);
}

// Each line of a table is of a settled gyro.
Finding find_in_table(const recording::Recording& table, const compare::RunSummary& summary) {
  const auto& degc = table.temperature_degc;
  const auto [min, max] = std::minmax_element(degc.begin(), degc.end());
  const std::string turned = is_turned(table) ? ",scale_factor" : "";
  return {"a table: " +
              words(counted(table.rows(), "mean") + format(" at %.1f to %.1f degC", *min, *max)) +
              (summary.bias.std_dph
                   ? ", which scatter by " + number(*summary.bias.std_dph) + " deg/h (std)"
                   : Text()),
          {"it shows no effect of the temperature's rate or history, of time, and no noise; "
           "fit what temperature does",
           {"fogcomp", "fit", table.file, "-o", "gyro.model", "--effects",
            "bias,bias_temperature:order=2" + turned}}};
}

Finding find(const recording::Recording& recording, recording::TemperatureCourse course,
             const compare::RunSummary& summary, const std::string& first_effects) {
  if (recording.is_table) return find_in_table(recording, summary);
  const std::optional<double> drift = summary.drift_dph(summary.bias);
  const double length_s = recording.time_s.back() - recording.time_s.front();
  if (!drift && recording.stretch_starts.size() > 1 && length_s >= 2 * summary.average_s) {
    return {words(format("gaps leave no two whole means of %.4g s, which drift needs",
                         summary.average_s)),
            {"see why samples are lost, or give a shorter --average"}};
  }
  if (!drift) {
    return {"the recording is too short to tell drift from noise",
            {"record for longer: a day in a chamber shows what temperature does"}};
  }
  const Text error = words(format("means of %.4g s scatter by ", summary.average_s)) +
                     number(*summary.bias.std_dph) + " deg/h (std), noise alone would make " +
                     number(*summary.noise_floor_dph);
  if (course == recording::TemperatureCourse::steady) {
    return {"the temperature stands still: " + error,
            {"this run shows noise and warm-up only; record one in which the temperature moves"}};
  }
  return {number(*drift) + " deg/h of drift: " + error,
          {"fit physical effects to it, then look at what they leave",
           {"fogcomp", "fit", recording.file, "-o", "gyro.model", "--effects", first_effects}}};
}

std::string duration(double seconds) {
  if (seconds < 120) return format("%.4g s", seconds);
  if (seconds < 2 * kSecondsPerHour) return format("%.1f min", seconds / 60);
  return format("%.2f h", seconds / kSecondsPerHour);
}

// What moved the temperature, unless that is a chamber's programme.
std::string course_words(const recording::Recording& recording,
                         recording::TemperatureCourse course) {
  const auto& degc = recording.temperature_degc;
  switch (course) {
    case recording::TemperatureCourse::settling:
      return format("a temperature that settles, %.1f to %.1f degC with a time constant of ",
                    degc.front(), degc.back()) +
             duration(recording::settling_time_s(recording)) +
             ": a gyro that warms itself up, or one step of its surroundings; what the temperature "
             "does cannot be told from what its rate does";
    case recording::TemperatureCourse::day:
      return "a temperature that moves as slowly as the day: outdoors, or in a room";
    case recording::TemperatureCourse::free:
      return "a temperature that goes up and down and never stands: a cycle without soaks, or use";
    default:
      return "";
  }
}

// Effects that could be told from all others if they were as large as the whole drift.
std::string shown_words(const std::vector<planning::VisibleSize>& visible, double drift_dph) {
  std::vector<std::string> shown;
  std::vector<std::string> hidden;
  for (const planning::VisibleSize& each : visible) {
    (each.visible_dph < drift_dph ? shown : hidden).push_back(each.effect);
  }
  if (visible.empty()) return "";
  const std::string what = shown.empty() ? "no effect of the catalogue" : join(shown, ", ");
  return what +
         (hidden.empty() ? "" : "; not, even as large as the whole drift: " + join(hidden, ", "));
}

std::vector<Lead> leads_of(const recording::Recording& recording,
                           recording::TemperatureCourse course, const compare::RunSummary& summary,
                           const std::vector<planning::VisibleSize>& visible) {
  const std::string what = course_words(recording, course);
  if (what.empty()) return {};
  const std::optional<double> drift_dph = summary.drift_dph(summary.bias);
  return without_empty(
      {{"what it is", words(what)},
       {"can show", drift_dph ? words(shown_words(visible, *drift_dph)) : Text()}});
}

// Extent of the data, and rows left out.
Parts extent(const recording::Recording& recording) {
  std::string text = counted(recording.rows(), recording.is_table ? "line" : "sample");
  if (recording.period_s > 0) {
    const double length_s = recording.time_s.back() - recording.time_s.front();
    text += format(" at %.6g Hz, %s", 1 / recording.period_s,
                   duration(length_s + recording.period_s).c_str());
  }
  if (recording.rows_per_row > 1) text += format(", each the mean of %zu", recording.rows_per_row);
  const std::size_t gaps = recording.is_table ? 0 : recording.stretch_starts.size() - 1;
  if (gaps > 0) text += ", " + counted(gaps, "gap");
  const std::size_t restarts = recording.restarts();
  if (restarts > 0) text += ", " + counted(restarts, "restart");
  if (recording.bad_rows > 0) text += ", " + counted(recording.bad_rows, "bad row") + " left out";
  if (recording.empty_rows > 0) {
    text += ", " + counted(recording.empty_rows, "sample") + " without a value left out";
  }
  Parts parts = Sentence{words(text)};
  if (recording.refused_rows > 0) {
    parts += Sentence{
        words(counted(recording.refused_rows, "sample") + " left out by the board's rules")};
  }
  if (recording.capture) parts += Sentence{words(recording::describe(*recording.capture))};
  if (recording.rows() > 1 && !recording::rate_resolution(recording).varies()) {
    parts += Sentence{"note: the rate does not move; is the gyro on and connected?"};
  }
  return parts;
}

// Where the temperature goes one way only, it cannot be told from time.
Text programme_words(recording::TemperatureCourse course, const compare::RunSummary& summary) {
  if (course == recording::TemperatureCourse::steady) return {};
  bool rises = false;
  bool falls = false;
  double fastest = 0;
  for (const compare::SegmentSummary& segment : summary.segments) {
    if (segment.kind == recording::SegmentKind::soak) continue;
    (segment.kind == recording::SegmentKind::ramp_up ? rises : falls) = true;
    fastest = std::max(fastest, std::fabs(segment.temperature_rate_degc_per_min));
  }
  const auto& degc = summary.blocks.temperature_degc;
  const auto [min, max] = std::minmax_element(degc.begin(), degc.end());
  std::string text = format("temperature %.1f to %.1f degC", *min, *max);
  if (!rises && !falls) return words(text);
  text += format(", ramps of up to %.3g degC/min in the mean, ", fastest);
  text += rises && falls ? "both ways" : rises ? "up only" : "down only";
  if (rises != falls) {
    text +=
        ": what it does cannot be told from what time since power-on does (warm_up, aging); "
        "record a way back, too";
  }
  return words(text);
}

Parts bias_section(bool of_lines, const compare::RunSummary& summary) {
  const compare::BiasSummary& bias = summary.bias;
  Table table;
  table.columns = {"bias (rate less input rate)", "deg/h"};
  table.rows = {{"mean", number(bias.mean_dph)}};
  if (of_lines) {
    table.rows.push_back({"std of the lines", dph(bias.std_dph)});
    return table;
  }
  table.rows = {
      {"mean", number(bias.mean_dph)},
      {words(format("std of %.4g s means", summary.average_s)), dph(bias.std_dph)},
      {"noise floor of such a mean", dph(summary.noise_floor_dph)},
      {"drift, sqrt(std^2 - floor^2)", dph(summary.drift_dph(bias))},
  };
  const std::string outliers =
      summary.outliers > 0 ? noise::outlier_words(summary.outliers, summary.average_s) : "";
  return table + Sentence{words(outliers)};
}

Table segment_table(const compare::RunSummary& summary) {
  Table table;
  table.columns = {"segment", "mean, deg/h", "drift, deg/h", "std, deg/h",
                   "degC",    "degC/min",    "from, h",      "length, h"};
  for (const compare::SegmentSummary& segment : summary.segments) {
    table.rows.push_back(
        {verbatim(segment.name), number(segment.bias.mean_dph),
         dph(summary.drift_dph(segment.bias)), dph(segment.bias.std_dph),
         verbatim(format("%.2f..%.2f", segment.temperature_min_degc, segment.temperature_max_degc)),
         verbatim(format("%.3f", segment.temperature_rate_degc_per_min)),
         verbatim(format("%.2f", segment.start_s / kSecondsPerHour)),
         verbatim(format("%.2f", segment.duration_s / kSecondsPerHour))});
  }
  return table;
}

std::vector<recording::Segment> summary_segments(const compare::RunSummary& summary) {
  std::vector<recording::Segment> segments;
  for (const compare::SegmentSummary& one : summary.segments) {
    segments.push_back({one.name, one.kind, one.start_s, one.start_s + one.duration_s, {}});
  }
  return segments;
}

Parts over_time(const recording::Recording& recording, const compare::RunSummary& summary) {
  const recording::Recording& blocks = summary.blocks;
  if (blocks.rows() < 2) return {};
  const std::vector<double> bias = recording::bias_dph(blocks);
  const TimeAxis axis{blocks.time_s, blocks.stretch_starts, "run", summary_segments(summary)};
  Plot means = time_plot(words(format("Bias, means of %.4g s.", summary.average_s)), "bias, deg/h",
                         axis, {{"bias", "residual", bias}});
  means.caption = "Mean " + number(summary.bias.mean_dph) + " deg/h, std " +
                  dph(summary.bias.std_dph) + "; noise alone would make " +
                  dph(summary.noise_floor_dph) + ".";
  Parts parts = Heading{"Over time"} + means + temperature_plot(axis, blocks.temperature_degc);
  if (recording.rows() == blocks.rows()) return parts;
  const TimeAxis samples{recording.time_s, recording.stretch_starts, "run", axis.segments};
  const bool has_input = !recording.input_rate_dph.empty();
  const std::vector<double> less_input =
      has_input ? recording::bias_dph(recording) : std::vector<double>();
  const std::vector<double>& sample_bias = has_input ? less_input : recording.rate_dph;
  Plot every = time_plot("Samples.", "bias, deg/h", samples, {{"sample", "second", sample_bias}});
  every.caption = "Std " + dph(summary.bias.sample_std_dph) + " deg/h.";
  return parts + every;
}

// Decimals that show `digits` digits of a value of this size.
int decimals_for(double size, int digits) {
  if (!(size > 0)) return digits;
  return std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(size))), 0, 12);
}

// As many digits as its uncertainty justifies.
Text to_digits_of(double value, double uncertainty) {
  return verbatim(format("%.*f", decimals_for(uncertainty, 2), value));
}

Table coefficient_table(const compare::RunSummary& summary) {
  Table table;
  table.caption = "noise coefficients (IEEE Std 952)";
  table.columns = {"coefficient", "value", "+- (95 %)", "unit"};
  const auto add = [&](const char* name, const std::optional<noise::NoiseCoefficient>& one,
                       const Text& otherwise, const char* unit) {
    table.rows.push_back({name, one ? to_digits_of(one->value, one->half_width_95) : otherwise,
                          one ? to_digits_of(one->half_width_95, one->half_width_95) : Text(),
                          unit});
  };
  const noise::NoiseCoefficients& noise = summary.noise;
  add("Q  quantization", noise.quantization_deg, "not shown", "deg");
  add("N  angle random walk", noise.angle_random_walk_dprh, "not shown", "deg/sqrt(h)");
  const double bound_dph = noise::instability_bound_dph(summary.allan);
  add("B  bias instability", noise.bias_instability_dph,
      "below " + to_digits_of(bound_dph, bound_dph), "deg/h");
  add("K  rate random walk", noise.rate_random_walk_dphrh, "not shown", "deg/h/sqrt(h)");
  add("R  rate ramp", noise.rate_ramp_dphh, "not shown", "deg/h/h");
  return table;
}

Parts noise_section(const compare::RunSummary& summary) {
  const Heading heading{"Noise"};
  if (summary.allan.empty()) {
    return heading + Sentence{
                         "no soak is long enough for an Allan deviation; on a ramp it would show "
                         "drift, not noise"};
  }
  Table table;
  table.caption = words("overlapping Allan deviation in " + duration(summary.soak_s) + " of soaks");
  table.columns = {"tau, s", "sigma, deg/h", "+- (1 sigma)"};
  for (const noise::AllanPoint& point : summary.allan) {
    table.rows.push_back({verbatim(format("%.6g", point.tau_s)),
                          to_digits_of(point.sigma, point.one_sigma),
                          to_digits_of(point.one_sigma, point.one_sigma)});
  }
  return heading + allan_plot({{"bias", "residual", summary.allan}}, summary.noise) +
         show(Shown::in_details, table) + coefficient_table(summary);
}

Parts over_temperature(const compare::RunSummary& summary) {
  const recording::Recording& blocks = summary.blocks;
  const compare::TemperatureSensitivity& sensitivity = summary.sensitivity;
  const std::vector<compare::Branch> branch = compare::branches(blocks.temperature_degc);
  Plot plot;
  if (ever_moves(branch)) {
    plot = branch_plot("Bias over temperature.", "temperature, degC", "bias, deg/h",
                       blocks.temperature_degc, recording::bias_dph(blocks), branch);
    if (sensitivity.hysteresis_dph) {
      plot.caption = "Heating and cooling lie up to " + number(*sensitivity.hysteresis_dph) +
                     words(format(" deg/h apart, at %.0f degC.", *sensitivity.hysteresis_at_degc));
    }
  }
  Table table;
  table.columns = {"sensitivity", "value", "unit"};
  const auto add = [&](const Text& name, const std::optional<double>& value, const Text& unit) {
    table.rows.push_back({name, value ? to_digits_of(*value, *value / 10) : Text("not shown"),
                          value ? unit : Text()});
  };
  add("bias to temperature", sensitivity.bias_dph_per_degc,
      words(format("deg/h/degC (worst soak, from %.0f degC)",
                   sensitivity.reference_degc.value_or(0))));
  add("to temperature rate, heating", sensitivity.heating_dph_per_degc_per_min, "deg/h/(degC/min)");
  add("to temperature rate, cooling", sensitivity.cooling_dph_per_degc_per_min, "deg/h/(degC/min)");
  add("hysteresis, widest loop", sensitivity.hysteresis_dph,
      words(format("deg/h (at %.0f degC)", sensitivity.hysteresis_at_degc.value_or(0))));
  return Heading{"Over temperature"} + plot + table;
}

// The bias as a function of each varying input, the input rate first.
Parts over_inputs(const compare::RunSummary& summary) {
  const recording::Recording& blocks = summary.blocks;
  const std::vector<double> bias = recording::bias_dph(blocks);
  const std::vector<compare::Branch> branch = compare::branches(blocks.temperature_degc);
  const auto over = [&](fog::Input input, const std::vector<double>& values) {
    return values.size() != bias.size() || !compare::varies(values)
               ? Plot()
               : branch_plot("Bias over " + input_name(input) + ".", input_label(input),
                             "bias, deg/h", values, bias, branch);
  };
  Parts parts = over(fog::Input::input_rate, blocks.input_rate_dph);
  if (summary.input_rate_share) {
    parts += Sentence{words(format("the input rate explains %.0f %% of the bias's variance",
                                   100 * *summary.input_rate_share))};
  }
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
    parts += over(fog::extension_input(i), blocks[fog::extension_input(i)]);
  }
  return parts;
}

}  // namespace

Document info_findings(const recording::Recording& recording, const compare::RunSummary& summary,
                       const planning::Prospect& prospect) {
  const recording::TemperatureCourse course = recording::temperature_course(recording);
  const Finding finding = find(recording, course, summary, prospect.first_effects);
  const std::vector<planning::VisibleSize>& visible = prospect.visible;
  Document document{"fogcomp info " + recording.file, finding.found, finding.next,
                    leads_of(recording, course, summary, visible)};
  document.parts = extent(recording) + Sentence{programme_words(course, summary)} +
                   bias_section(recording.is_table, summary);
  if (recording.rows() == 1) return document;
  if (!recording.is_table) {
    document.parts += Heading{"Segments"} + segment_table(summary);
    document.parts += over_time(recording, summary);
  }
  document.parts += over_temperature(summary) + over_inputs(summary);
  if (!recording.is_table) document.parts += noise_section(summary);
  if (!visible.empty()) {
    document.parts += Heading{"What it can show"} + visible_table(visible, "these rows");
  }
  return document;
}

}  // namespace fogcomp::findings
