#include "findings/json.hpp"

#include <cmath>

namespace fogcomp::findings {
namespace {

Json segment_json(const compare::Comparison::SegmentError& segment,
                  const std::optional<double>& floor_dph) {
  return Json::object()
      .set("name", segment.name)
      .set("rows", segment.rows.size())
      .set("mean_dph", segment.mean_dph)
      .set("std_dph", segment.std_dph)
      .set("rms_dph", segment.rms_dph)
      .set("raw_mean_dph", segment.raw_mean_dph)
      .set("raw_std_dph", segment.raw_std_dph)
      .set("raw_rms_dph", segment.raw_rms_dph)
      .set("drift_left_dph", compare::floor_removed(segment.rms_dph, floor_dph));
}

Json effects_json(const std::vector<compare::EffectShare>& effects) {
  return json_array(effects, [&](const compare::EffectShare& effect) {
    return Json::object()
        .set("effect", effect.name)
        .set("mean_dph", effect.mean_dph)
        .set("std_dph", effect.std_dph)
        .set("share", effect.share);
  });
}

Json test_json(const compare::ResidualAnalysis& analysis, const compare::ClassTest& test) {
  return Json::object()
      .set("structured", test.structured())
      .set("score", test.score)
      .set("share_of_excess", analysis.share_of_excess(test));
}

Json dependence_json(const compare::ResidualAnalysis& analysis,
                     const compare::Dependence& dependence) {
  using Bin = compare::ResidualBin;
  return test_json(analysis, dependence.test)
      .set("at", members(dependence.bins, &Bin::at))
      .set("mean_dph", members(dependence.bins, &Bin::mean_dph))
      .set("sigma_dph", members(dependence.bins, &Bin::sigma_dph))
      .set("rows", members(dependence.bins, &Bin::rows));
}

Json loop_json(const compare::ResidualAnalysis& analysis) {
  using Bin = compare::LoopBin;
  const compare::Loop& loop = analysis.history;
  const Bin* const widest = loop.widest();
  return test_json(analysis, loop.test)
      .set("loop_width_dph",
           member_or_null(widest, [](const Bin& bin) { return std::abs(bin.width_dph()); }))
      .set("loop_sigma_dph", member_or_null(widest, &Bin::sigma_dph))
      .set("loop_at_degc", member_or_null(widest, &Bin::at_degc))
      .set("at", members(loop.bins, &Bin::at_degc))
      .set("heating_dph", members(loop.bins, &Bin::heating_dph))
      .set("cooling_dph", members(loop.bins, &Bin::cooling_dph))
      .set("sigma_dph", members(loop.bins, &Bin::sigma_dph));
}

Json structure_json(const compare::Comparison& comparison,
                    const compare::ResidualAnalysis& analysis) {
  Json object = Json::object();
  object.set("excess_dph2", analysis.excess_dph2)
      .set("temperature_degc", dependence_json(analysis, analysis.temperature))
      .set("temperature_rate", dependence_json(analysis, analysis.rate))
      .set("time_s", dependence_json(analysis, analysis.time))
      .set("history", loop_json(analysis))
      .set("offset",
           test_json(analysis, analysis.offset).set("sigma_dph", analysis.offset_sigma_dph))
      .set("input_rate_share", analysis.input_rate_share);
  for (std::size_t i = 0; i < analysis.inputs.size(); ++i) {
    object.set(description_of(comparison.inputs[i].input).column,
               dependence_json(analysis, analysis.inputs[i]));
  }
  return object;
}

Json autocorrelation_json(const compare::ResidualAnalysis& analysis) {
  using Lag = compare::LagCorrelation;
  return Json::object()
      .set("lag_s", members(analysis.autocorrelation, &Lag::lag_s))
      .set("correlation", members(analysis.autocorrelation, &Lag::correlation))
      .set("white_band", analysis.white_band);
}

Json allan_json(const compare::ResidualAnalysis& analysis) {
  using Point = noise::AllanPoint;
  return Json::object()
      .set("tau_s", members(analysis.raw_allan, &Point::tau_s))
      .set("raw_dph", members(analysis.raw_allan, &Point::sigma))
      .set("residual_dph", members(analysis.residual_allan, &Point::sigma))
      .set("raw_one_sigma_dph", members(analysis.raw_allan, &Point::one_sigma))
      .set("residual_one_sigma_dph", members(analysis.residual_allan, &Point::one_sigma));
}

Json outside_json(const compare::OutsideTraining& outside) {
  Json object = Json::object();
  object.set("temperature", outside.temperature)
      .set("temperature_rate", outside.temperature_rate)
      .set("sooner", outside.sooner)
      .set("later", outside.later)
      .set(description_of(fog::Input::input_rate).column, outside.input_rate);
  for (std::size_t i = 0; i < outside.inputs.size(); ++i) {
    object.set(description_of(fog::extension_input(i)).column, outside.inputs[i]);
  }
  return object;
}

Json band_json(const compare::PredictiveBand& band) {
  return Json::object()
      .set("row_s", band.row_s)
      .set("within_1_sigma", band.share_within(1))
      .set("within_2_sigma", band.share_within(2))
      .set("time_s", band.time_s)
      .set("residual_dph", band.residual_dph)
      .set("sigma_dph", band.sigma_dph);
}

Json run_json(const compare::ModelOnRun& run) {
  const compare::Comparison& comparison = run.comparison;
  const compare::Comparison::SegmentError& whole = comparison.whole;
  Json segments =
      json_array(comparison.segments, [&](const compare::Comparison::SegmentError& segment) {
        return segment_json(segment, comparison.noise_floor_dph);
      });
  return Json::object()
      .set("file", comparison.file)
      .set("rows", comparison.size())
      .set("outliers", comparison.outliers)
      .set("row_s", comparison.rows.row_s)
      .set("raw_mean_dph", whole.raw_mean_dph)
      .set("raw_std_dph", whole.raw_std_dph)
      .set("raw_rms_dph", whole.raw_rms_dph)
      .set("residual_mean_dph", whole.mean_dph)
      .set("residual_rms_dph", whole.rms_dph)
      .set("residual_rms_without_delay_dph", run.error.without_delay_dph)
      .set("residual_std_dph", whole.std_dph)
      .set("noise_floor_dph", comparison.noise_floor_dph)
      .set("below_noise_floor", compare::is_below_floor(comparison))
      .set("drift_before_dph",
           compare::floor_removed(whole.raw_std_dph, comparison.noise_floor_dph))
      .set("drift_left_dph", compare::floor_removed(whole.rms_dph, comparison.noise_floor_dph))
      .set("segments", std::move(segments))
      .set("effects", effects_json(comparison.effects))
      .set("structure", structure_json(run.comparison, run.analysis))
      .set("autocorrelation", autocorrelation_json(run.analysis))
      .set("allan", allan_json(run.analysis))
      .set("band", run.band ? band_json(*run.band) : Json())
      .set("outside_training", outside_json(comparison.outside));
}

Json model_json(const compare::ModelOnRuns& model, Json object) {
  object.set("runs", json_array(model.runs, run_json))
      .set("extrapolated_fraction", model.extrapolated_fraction())
      .set(turn_on_json(model.turn_on));
  return object;
}

}  // namespace

Json turn_on_json(const compare::TurnOn& turn_on) {
  Json biases = json_array(turn_on.biases, [](const compare::TurnOnBias& run) {
    return Json::object()
        .set("file", run.run)
        .set("from_s", run.from_s)
        .set("reference", run.reference)
        .set("above_dph", run.above_dph)
        .set("sigma_dph", run.sigma_dph)
        .set("certain", run.certain);
  });
  return Json::object()
      .set("turn_on_bias", std::move(biases))
      .set("turn_on_repeatability", Json::object()
                                        .set("sigma_dph", turn_on.repeatability_dph)
                                        .set("differs", turn_on.differs));
}

Json compare_json(const std::vector<compare::ModelOnRuns>& models) {
  Json result = model_json(models[0], Json::object());
  Json all = json_array(models, [&](const compare::ModelOnRuns& model) {
    return model_json(model, Json::object().set("model", model.file));
  });
  result.set("models", std::move(all));
  return result;
}

}  // namespace fogcomp::findings
