#include "findings/json.hpp"

#include "recording/segments.hpp"

namespace fogcomp::findings {
namespace {

const char* kind_name(recording::SegmentKind kind) {
  if (kind == recording::SegmentKind::soak) return "soak";
  return kind == recording::SegmentKind::ramp_up ? "ramp_up" : "ramp_down";
}

Json segments_json(const std::vector<compare::SegmentSummary>& segments) {
  return json_array(segments, [&](const compare::SegmentSummary& segment) {
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

Json allan_json(const std::vector<noise::AllanPoint>& points) {
  using Point = noise::AllanPoint;
  return Json::object()
      .set("tau_s", members(points, &Point::tau_s))
      .set("sigma_dph", members(points, &Point::sigma))
      .set("one_sigma_dph", members(points, &Point::one_sigma));
}

template <class Figure>
Json coefficients_json(const noise::NoiseCoefficients& noise, Figure figure) {
  return Json::object()
      .set("angle_random_walk_dprh", member_or_null(noise.angle_random_walk_dprh, figure))
      .set("bias_instability_dph", member_or_null(noise.bias_instability_dph, figure))
      .set("rate_random_walk_dphrh", member_or_null(noise.rate_random_walk_dphrh, figure))
      .set("rate_ramp_dphh", member_or_null(noise.rate_ramp_dphh, figure))
      .set("quantization_deg", member_or_null(noise.quantization_deg, figure));
}

Json capture_json(const recording::CaptureCounts& counts) {
  return Json::object()
      .set("discarded_bytes", counts.discarded_bytes)
      .set("missing_samples", counts.missing_samples)
      .set("late_samples", counts.late_samples)
      .set("invalid_samples", counts.invalid_samples)
      .set("held_temperatures", counts.held_temperatures);
}

}  // namespace

Json info_json(const recording::Recording& recording, const compare::RunSummary& summary,
               const planning::Prospect& prospect) {
  Json object = Json::object();
  object.set("file", recording.file)
      .set("rows", recording.rows())
      .set("rows_per_row", recording.rows_per_row)
      .set("bad_rows", recording.bad_rows)
      .set("empty_rows", recording.empty_rows)
      .set("refused_rows", recording.refused_rows)
      .set("gaps", recording.is_table ? 0 : recording.stretch_starts.size() - 1)
      .set("restarts", recording.restarts())
      .set("course", recording::course_name(recording::temperature_course(recording)))
      .set("period_s", recording.period_s)
      .set("average_s", summary.average_s)
      .set("outliers", summary.outliers)
      .set("mean_dph", summary.bias.mean_dph)
      .set("std_dph", summary.bias.std_dph)
      .set("sample_std_dph", summary.bias.sample_std_dph)
      .set("noise_floor_dph", summary.noise_floor_dph)
      .set("segments", segments_json(summary.segments))
      .set("allan", allan_json(summary.allan))
      .set(coefficients_json(summary.noise, &noise::NoiseCoefficient::value));
  if (recording.capture) object.set("capture", capture_json(*recording.capture));
  const compare::TemperatureSensitivity& sensitivity = summary.sensitivity;
  object
      .set("half_width_95",
           coefficients_json(summary.noise, &noise::NoiseCoefficient::half_width_95))
      .set("bias_temperature_sensitivity_dph_per_degc", sensitivity.bias_dph_per_degc)
      .set("temperature_rate_sensitivity_heating_dph_per_degc_per_min",
           sensitivity.heating_dph_per_degc_per_min)
      .set("temperature_rate_sensitivity_cooling_dph_per_degc_per_min",
           sensitivity.cooling_dph_per_degc_per_min)
      .set("hysteresis_dph", sensitivity.hysteresis_dph)
      .set("hysteresis_at_degc", sensitivity.hysteresis_at_degc)
      .set("first_effects", prospect.first_effects)
      .set("visible", visible_json(prospect.visible));
  return object;
}

}  // namespace fogcomp::findings
