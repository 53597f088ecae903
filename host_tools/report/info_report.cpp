#include "report/info_report.hpp"

#include <cmath>

#include "compare/comparison.hpp"
#include "model/effect_list.hpp"
#include "report/allan_plot.hpp"
#include "report/figures.hpp"
#include "report/run_plots.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::report {
namespace {

struct Finding {
  Text found;
  Text next;
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
  const Text error = words(format("means of %.4g s scatter by ", summary.average_s)) +
                     number(deviation) + " deg/h (std), noise alone would make " + number(floor);
  bool ramps = false;
  for (const SegmentSummary& segment : summary.segments) {
    ramps = ramps || segment.kind != SegmentKind::soak;
  }
  if (!ramps) {
    return {"The temperature stands still: " + error + ".",
            "this run shows noise and warm-up only; record one in which the temperature moves.",
            ""};
  }
  return {number(drift) + " deg/h of drift: " + error + ".",
          "fit physical effects to it, then look at what they leave.",
          "fogcomp fit " + recording.file + " -o gyro.model --effects " + kFirstEffects};
}

void add_overview(Report& report, const Recording& recording, const RunSummary& summary) {
  const BiasSummary& bias = summary.bias;
  Table table{{"bias (rate less input rate)", ""}, {}};
  const auto add = [&](const Text& name, const Text& value) {
    table.rows.push_back({name, value});
  };
  add("rows", verbatim(std::to_string(recording.rows())));
  if (recording.period_s > 0) {
    add("sample rate, Hz", verbatim(format("%.6g", 1 / recording.period_s)));
  }
  add("gaps", verbatim(std::to_string(recording.stretch_starts.size() - 1)));
  add("mean, deg/h", number(bias.mean_dph));
  add(words(format("std of %.4g s means, deg/h", summary.average_s)), dph(bias.std_dph));
  add("noise floor of such a mean, deg/h", dph(summary.noise_floor_dph));
  if (bias.std_dph && summary.noise_floor_dph) {
    add("drift, √(std² − floor²), deg/h",
        number(floor_removed(*bias.std_dph, *summary.noise_floor_dph)));
  }
  report.table(table);
}

void add_segments(Report& report, const RunSummary& summary) {
  Table table{{"segment", "mean, deg/h", "drift, deg/h", "std, deg/h", "degC", "degC/min",
               "from, h", "length, h"},
              {}};
  for (const SegmentSummary& segment : summary.segments) {
    std::optional<double> drift;
    if (segment.bias.std_dph && summary.noise_floor_dph) {
      drift = floor_removed(*segment.bias.std_dph, *summary.noise_floor_dph);
    }
    table.rows.push_back({verbatim(segment.name), number(segment.bias.mean_dph), dph(drift),
                          dph(segment.bias.std_dph),
                          verbatim(format("%.2f to %.2f", segment.temperature_min_degc,
                                          segment.temperature_max_degc)),
                          verbatim(format("%.3f", segment.temperature_rate_degc_per_min)),
                          verbatim(format("%.2f", segment.start_s / kSecondsPerHour)),
                          verbatim(format("%.2f", segment.duration_s / kSecondsPerHour))});
  }
  report.section("Segments");
  report.table(table);
}

std::vector<Segment> summary_segments(const RunSummary& summary) {
  std::vector<Segment> segments;
  for (const SegmentSummary& one : summary.segments) {
    segments.push_back({one.name, one.kind, one.start_s, one.start_s + one.duration_s, {}});
  }
  return segments;
}

void add_over_time(Report& report, const Recording& recording, const RunSummary& summary) {
  const Recording& blocks = summary.blocks;
  if (blocks.rows() < 2) return;
  const std::vector<double> bias = bias_dph(blocks);
  const TimeAxis axis{blocks.time_s, blocks.stretch_starts, "run", summary_segments(summary)};
  report.section("Over time");
  Plot means = time_plot(words(format("Bias, means of %.4g s.", summary.average_s)), "bias, deg/h",
                         axis, {{"bias", "residual", bias}});
  means.caption = "Mean " + number(summary.bias.mean_dph) + " deg/h, std " +
                  dph(summary.bias.std_dph) + "; noise alone would make " +
                  dph(summary.noise_floor_dph) + ".";
  report.plot(means);
  report.plot(temperature_plot(axis, blocks.temperature_degc));
  if (recording.rows() == blocks.rows()) return;
  const TimeAxis samples{recording.time_s, recording.stretch_starts, "run", axis.segments};
  const std::vector<double> sample_bias = bias_dph(recording);
  Plot every = time_plot("Samples.", "bias, deg/h", samples, {{"sample", "second", sample_bias}});
  every.caption = "Std " + dph(summary.bias.sample_std_dph) + " deg/h.";
  report.plot(every);
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
    table.rows.push_back({name, one ? verbatim(format("%.3g", one->value)) : Text("not shown"),
                          one ? verbatim(format("%.2g", one->half_width_95)) : Text(), unit});
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
  const TemperatureSensitivity& sensitivity = summary.sensitivity;
  const std::vector<Branch> branch = branches(blocks.temperature_degc);
  report.section("Over temperature");
  if (ever_moves(branch)) {
    Plot plot = branch_plot("Bias over temperature.", "temperature, degC", "bias, deg/h",
                            blocks.temperature_degc, bias_dph(blocks), branch);
    if (sensitivity.hysteresis_dph) {
      plot.caption = "Heating and cooling lie up to " + number(*sensitivity.hysteresis_dph) +
                     words(format(" deg/h apart, at %.0f degC.", *sensitivity.hysteresis_at_degc));
    }
    report.plot(plot);
  }
  Table table{{"sensitivity", "value", "unit"}, {}};
  const auto add = [&](const Text& name, const std::optional<double>& value, const Text& unit) {
    table.rows.push_back(
        {name, value ? verbatim(format("%.3g", *value)) : Text("not shown"), unit});
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
