#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/gyro_limit_options.hpp"
#include "cli/info_text.hpp"
#include "cli/recording_options.hpp"
#include "cli/report_option.hpp"
#include "cli/watch.hpp"
#include "report/info_report.hpp"
#include "support/json.hpp"
#include "workflow/info.hpp"

namespace fogcomp::cli {
namespace {

Json value_or_null(const std::optional<NoiseCoefficient>& coefficient) {
  return coefficient ? Json(coefficient->value) : Json();
}

Json half_width_or_null(const std::optional<NoiseCoefficient>& coefficient) {
  return coefficient ? Json(coefficient->half_width_95) : Json();
}

const char* kind_name(SegmentKind kind) {
  if (kind == SegmentKind::soak) return "soak";
  return kind == SegmentKind::ramp_up ? "ramp_up" : "ramp_down";
}

Json segments_json(const std::vector<SegmentSummary>& segments) {
  return json_array(segments, [&](const SegmentSummary& segment) {
    return Json::object()
        .set("name", segment.name)
        .set("kind", kind_name(segment.kind))
        .set("start_s", segment.start_s)
        .set("end_s", segment.end_s)
        .set("rows", segment.rows)
        .set("mean_dph", segment.bias.mean_dph)
        .set("std_dph", segment.bias.std_dph)
        .set("sample_std_dph", segment.bias.sample_std_dph)
        .set("temperature_min_degc", segment.temperature_min_degc)
        .set("temperature_max_degc", segment.temperature_max_degc)
        .set("temperature_rate_degc_per_min", segment.temperature_rate_degc_per_min);
  });
}

Json allan_json(const std::vector<AllanPoint>& points) {
  std::vector<double> tau_s;
  std::vector<double> sigma_dph;
  std::vector<double> one_sigma_dph;
  for (const AllanPoint& point : points) {
    tau_s.push_back(point.tau_s);
    sigma_dph.push_back(point.sigma);
    one_sigma_dph.push_back(point.one_sigma);
  }
  return Json::object()
      .set("tau_s", tau_s)
      .set("sigma_dph", sigma_dph)
      .set("one_sigma_dph", one_sigma_dph);
}

void set_coefficients(Json& object, const NoiseCoefficients& noise,
                      Json (*as_json)(const std::optional<NoiseCoefficient>&)) {
  object.set("angle_random_walk_dprh", as_json(noise.angle_random_walk_dprh))
      .set("bias_instability_dph", as_json(noise.bias_instability_dph))
      .set("rate_random_walk_dphrh", as_json(noise.rate_random_walk_dphrh))
      .set("rate_ramp_dphh", as_json(noise.rate_ramp_dphh))
      .set("quantization_deg", as_json(noise.quantization_deg));
}

Json capture_json(const CaptureCounts& counts) {
  return Json::object()
      .set("discarded_bytes", counts.discarded_bytes)
      .set("missing_samples", counts.missing_samples)
      .set("late_samples", counts.late_samples)
      .set("invalid_samples", counts.invalid_samples)
      .set("held_temperatures", counts.held_temperatures);
}

Json info_json(const Recording& recording, const RunSummary& summary) {
  Json object = Json::object();
  object.set("file", recording.file)
      .set("rows", recording.rows())
      .set("bad_rows", recording.bad_rows)
      .set("refused_rows", recording.refused_rows)
      .set("gaps", recording.stretch_starts.size() - 1)
      .set("period_s", recording.period_s)
      .set("average_s", summary.average_s)
      .set("outliers", summary.outliers)
      .set("mean_dph", summary.bias.mean_dph)
      .set("std_dph", summary.bias.std_dph)
      .set("sample_std_dph", summary.bias.sample_std_dph)
      .set("noise_floor_dph", summary.noise_floor_dph)
      .set("segments", segments_json(summary.segments))
      .set("allan", allan_json(summary.allan));
  set_coefficients(object, summary.noise, value_or_null);
  Json half_widths = Json::object();
  set_coefficients(half_widths, summary.noise, half_width_or_null);
  if (recording.capture) object.set("capture", capture_json(*recording.capture));
  const TemperatureSensitivity& sensitivity = summary.sensitivity;
  object.set("half_width_95", std::move(half_widths))
      .set("bias_temperature_sensitivity_dph_per_degc", sensitivity.bias_dph_per_degc)
      .set("temperature_rate_sensitivity_heating_dph_per_degc_per_min",
           sensitivity.heating_dph_per_degc_per_min)
      .set("temperature_rate_sensitivity_cooling_dph_per_degc_per_min",
           sensitivity.cooling_dph_per_degc_per_min)
      .set("hysteresis_dph", sensitivity.hysteresis_dph)
      .set("hysteresis_at_degc", sensitivity.hysteresis_at_degc);
  return object;
}

struct InfoCommand : Command {
  Number average{this,
                 {"average", "S", "length of a block mean (a row where the rows are longer)", "10"},
                 {1e-6, 1e6}};
  ReportOption report{this};
  Flag json{this, "json", "print one JSON object"};
  RecordingOptions recording{this};
  GyroLimitOptions limits{this};

  InfoCommand()
      : Command("info", {"RUN", 1, 1},
                "segments, noise, Allan deviation, sensitivities of a recording",
                "fogcomp info run.csv --latitude 40 --axis up") {}
  int run() const override;
};

int InfoCommand::run() const {
  workflow::InfoRequest request{arguments.front(), recording.value(), average.find()};
  request.reading.limits = limits.value();
  ReportFile page(report);
  const auto [run, summary] = workflow::info(request, Watch().observer());
  if (page.wanted()) page.write(report::info_report(run, summary));
  if (json.given()) {
    std::puts(info_json(run, summary).text().c_str());
  } else {
    std::fputs(info_text(run, summary).c_str(), stdout);
  }
  return 0;
}

}  // namespace

CommandPointer info_command() {
  return std::make_unique<InfoCommand>();
}

}  // namespace fogcomp::cli
