#include "report/info_report.hpp"

#include <cmath>

#include "evaluation/comparison.hpp"
#include "identification/effect_list.hpp"
#include "report/allan_plot.hpp"
#include "report/figures.hpp"
#include "report/run_plots.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::report {
namespace {

struct Finding {
  std::string found;
  std::string next;
  std::string command;
};

Finding find(const Recording& recording, const RunSummary& summary) {
  if (!summary.bias.std_dph || !summary.noise_floor_dph) {
    return {"The recording is too short to tell drift from noise.",
            "record for longer: a day in a chamber shows what temperature does.", ""};
  }
  const double deviation = *summary.bias.std_dph;
  const double floor = *summary.noise_floor_dph;
  const double drift = floor_removed(deviation, floor);
  const std::string error =
      format("means of %.4g s scatter by %s deg/h (std), noise alone would make %s",
             summary.average_s, rounded(deviation).c_str(), rounded(floor).c_str());
  bool ramps = false;
  for (const SegmentSummary& segment : summary.segments) {
    ramps = ramps || segment.kind != SegmentKind::soak;
  }
  if (!ramps) {
    return {"The temperature stands still: " + error + ".",
            "this run shows noise and warm-up only; record one in which the temperature moves.",
            ""};
  }
  return {format("%s deg/h of drift: ", rounded(drift).c_str()) + error + ".",
          "fit physical effects to it, then look at what they leave.",
          "fogcomp fit " + recording.file + " -o gyro.model --effects " + kFirstEffects};
}

void add_overview(Report& report, const Recording& recording, const RunSummary& summary) {
  const BiasSummary& bias = summary.bias;
  Table table{{"bias (rate less input rate)", ""}, {}};
  table.rows.push_back({"rows", format("%zu", recording.rows())});
  if (recording.period_s > 0) {
    table.rows.push_back({"sample rate, Hz", format("%.6g", 1 / recording.period_s)});
  }
  table.rows.push_back({"gaps", format("%zu", recording.stretch_starts.size() - 1)});
  table.rows.push_back({"mean, deg/h", dph(bias.mean_dph)});
  table.rows.push_back(
      {format("std of %.4g s means, deg/h", summary.average_s), dph(bias.std_dph)});
  table.rows.push_back({"noise floor of such a mean, deg/h", dph(summary.noise_floor_dph)});
  if (bias.std_dph && summary.noise_floor_dph) {
    table.rows.push_back({"drift, √(std² − floor²), deg/h",
                          dph(floor_removed(*bias.std_dph, *summary.noise_floor_dph))});
  }
  report.table(table);
}

void add_segments(Report& report, const RunSummary& summary) {
  Table table{{"segment", "from, h", "length, h", "degC", "degC/min", "mean, deg/h", "std, deg/h",
               "drift, deg/h"},
              {}};
  for (const SegmentSummary& segment : summary.segments) {
    std::optional<double> drift;
    if (segment.bias.std_dph && summary.noise_floor_dph) {
      drift = floor_removed(*segment.bias.std_dph, *summary.noise_floor_dph);
    }
    table.rows.push_back(
        {segment.name, format("%.2f", segment.start_s / kSecondsPerHour),
         format("%.2f", segment.duration_s / kSecondsPerHour),
         format("%.2f .. %.2f", segment.temperature_min_degc, segment.temperature_max_degc),
         format("%.3f", segment.temperature_rate_degc_per_min), dph(segment.bias.mean_dph),
         dph(segment.bias.std_dph), dph(drift)});
  }
  report.section("Segments");
  report.table(table);
}

void add_over_time(Report& report, const Recording& recording, const RunSummary& summary) {
  const Recording& blocks = summary.blocks;
  if (blocks.rows() < 2) return;
  const std::vector<double> bias = bias_dph(blocks);
  const TimeAxis axis{blocks.time_s, blocks.stretch_starts, "run"};
  report.section("Over time");
  report.plot(time_plot(format("Bias, means of %.4g s.", summary.average_s), "bias, deg/h", axis,
                        {{"bias", "residual", bias}}));
  report.plot(time_plot("Temperature.", "temperature, degC", axis,
                        {{"temperature", "model", blocks.temperature_degc}}));
  if (recording.rows() == blocks.rows()) return;
  const TimeAxis samples{recording.time_s, recording.stretch_starts, "run"};
  const std::vector<double> sample_bias = bias_dph(recording);
  report.plot(time_plot("Samples.", "bias, deg/h", samples, {{"sample", "second", sample_bias}}));
}

void add_noise(Report& report, const RunSummary& summary) {
  report.section("Noise");
  if (summary.allan.empty()) {
    report.sentence(
        "No soak is long enough for an Allan deviation; on a ramp it would show drift.");
    return;
  }
  report.plot(allan_plot({{"bias", "residual", summary.allan}}, summary.noise));
  Table table{{"coefficient (IEEE Std 952)", "value", "+- (95 %)", "unit"}, {}};
  const auto add = [&](const char* name, const std::optional<NoiseCoefficient>& one,
                       const char* unit) {
    table.rows.push_back({name, one ? format("%.3g", one->value) : "not shown",
                          one ? format("%.2g", one->half_width_95) : "", unit});
  };
  add("quantization Q", summary.noise.quantization_deg, "deg");
  add("angle random walk N", summary.noise.angle_random_walk_dprh, "deg/sqrt(h)");
  add("bias instability B", summary.noise.bias_instability_dph, "deg/h");
  add("rate random walk K", summary.noise.rate_random_walk_dphrh, "deg/h/sqrt(h)");
  add("rate ramp R", summary.noise.rate_ramp_dphh, "deg/h/h");
  report.table(table);
}

void add_over_temperature(Report& report, const RunSummary& summary) {
  const Recording& blocks = summary.blocks;
  report.section("Over temperature");
  report.plot(branch_plot("Bias over temperature.", "temperature, degC", "bias, deg/h",
                          blocks.temperature_degc, bias_dph(blocks),
                          branches(blocks.temperature_degc), summary.average_s));
  const TemperatureSensitivity& sensitivity = summary.sensitivity;
  Table table{{"sensitivity", "value", "unit"}, {}};
  const auto add = [&](const std::string& name, const std::optional<double>& value,
                       const char* unit) {
    table.rows.push_back({name, value ? format("%.3g", *value) : "not shown", unit});
  };
  add("bias to temperature (worst soak)", sensitivity.bias_dph_per_degc, "deg/h/degC");
  add("to temperature rate, heating", sensitivity.heating_dph_per_degc_per_min, "deg/h/(degC/min)");
  add("to temperature rate, cooling", sensitivity.cooling_dph_per_degc_per_min, "deg/h/(degC/min)");
  add("hysteresis, widest loop", sensitivity.hysteresis_dph, "deg/h");
  report.table(table);
}

}  // namespace

Report info_report(const Recording& recording, const RunSummary& summary) {
  const Finding finding = find(recording, summary);
  Report report("fogcomp info " + recording.file, finding.found);
  report.next(finding.next, finding.command);
  add_overview(report, recording, summary);
  add_over_time(report, recording, summary);
  add_over_temperature(report, summary);
  add_noise(report, summary);
  add_segments(report, summary);
  return report;
}

}  // namespace fogcomp::report
