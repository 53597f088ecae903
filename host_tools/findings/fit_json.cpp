#include "findings/json.hpp"

namespace fogcomp::findings {
namespace {

using workflow::FitOutcome;

// The gyro's own values, and those with which the board makes up for its delay.
Json terms_json(const model::Model& model) {
  return json_array(model.terms, [&](const model::EffectTerm& term) {
    std::vector<model::Estimate> shape;
    for (std::size_t i = 0; i < term.parameters.size(); ++i)
      shape.push_back(model::shape_value(term, i));
    const auto& coefficients_dph = term.gyro ? term.gyro->coefficients_dph : term.coefficients_dph;
    return Json::object()
        .set("effect", term.name)
        .set("parameters", members(shape, &model::Estimate::value))
        .set("parameter_sigma", members(shape, &model::Estimate::sigma))
        .set("coefficients_dph", members(coefficients_dph, &model::Estimate::value))
        .set("sigma_dph", members(coefficients_dph, &model::Estimate::sigma))
        .set("board_parameters", members(term.parameters, &model::Parameter::value))
        .set("board_coefficients_dph", members(term.coefficients_dph, &model::Estimate::value));
  });
}

}  // namespace

Json fit_json(const workflow::FitOutcome& fit, const std::string& output) {
  const fit::Identification& identified = fit.result.identified;
  Json notes = identified.warnings;
  if (fit.network_dropped()) notes.push(network_verdict(fit.result));
  Json result = Json::object();
  result.set("model", output).set("rows", static_cast<std::size_t>(fit.rows));
  result.set("refused_rows", fit.refused_rows());
  result.set("raw_std_dph", fit.result.raw_std_dph)
      .set("residual_rms_dph", fit.model.residual_rms_dph);
  result.set("misfit", identified.birge_ratio).set("outliers", identified.outliers);
  result.set("noise_white_dph", identified.noise.white_dph());
  result.set("noise_slow_dph", identified.noise.wander_dph());
  result.set("run_offsets_dph", identified.run_offsets_dph).set("notes", std::move(notes));
  result.set(turn_on_json(fit.turn_on)).set("delay_rms_dph", fit.delay_rms_dph);
  const auto& better = fit.better_derivative;
  result.set(
      "better_derivative", member_or_null(better, [](const fit::DerivativeChoice& choice) {
        return Json::object().set("tau_s", choice.tau_s).set("delay_rms_dph", choice.delay_rms_dph);
      }));
  result.set("masked_rows", identified.masked);
  result.set("effects", terms_json(fit.model));
  result.set("prior", prior_json(fit));
  result.set("network_hidden", static_cast<int>(fit.model.network.hidden.biases.size()));
  result.set("network_effective_parameters", fit.determined_weights());
  const std::optional<fit::OutOfSample>& judged = fit.result.network_judged;
  result.set("network_gain", judged ? Json(judged->score.gain) : Json());
  return result;
}

}  // namespace fogcomp::findings
