#include "findings/bias_step_words.hpp"

#include "findings/figures.hpp"
#include "model/catalogue.hpp"
#include "support/text.hpp"

namespace fogcomp::findings {
namespace {

std::string bias_words(const model::EffectTerm& step) {
  const std::string bias = step.bias_of_others();
  if (bias == "mean") return "the mean of this recording, because there are several";
  return "that " + bias + " it";
}

}  // namespace

bool is_found_step(const model::EffectTerm& term) {
  return model::is_event(term) && term.parameters[0].identified && !term.coefficients_dph.empty();
}

std::vector<model::EffectTerm> found_steps(const model::Model& model) {
  std::vector<model::EffectTerm> steps;
  for (const model::EffectTerm& term : model.terms) {
    if (is_found_step(term)) steps.push_back(term);
  }
  return steps;
}

Text bias_step_words(const model::EffectTerm& step, const std::string& place) {
  const model::Estimate& size_dph = step.coefficients_dph[0];
  const model::Parameter& time_s = step.parameters[0];
  Text text = words(format("bias step of %s +- %.2g deg/h at %.6g +- %.2g s",
                           signed_rounded(size_dph.value).c_str(), size_dph.sigma, time_s.value,
                           time_s.sigma));
  if (!place.empty()) text += " (" + verbatim(place) + ")";
  return text + words("; the model's bias is " + bias_words(step));
}

Json bias_step_json(const model::EffectTerm& step, const std::string& place) {
  return Json::object()
      .set("place", place.empty() ? Json() : Json(place))
      .set("time_s", step.parameters[0].value)
      .set("time_sigma_s", step.parameters[0].sigma)
      .set("size_dph", step.coefficients_dph[0].value)
      .set("size_sigma_dph", step.coefficients_dph[0].sigma)
      .set("model_bias", step.bias_of_others());
}

std::vector<Text> bias_steps_words(const model::Model& model,
                                   const std::vector<std::string>& places) {
  const std::vector<model::EffectTerm> steps = found_steps(model);
  std::vector<Text> all;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    all.push_back(bias_step_words(steps[i], places.empty() ? "" : places.at(i)));
  }
  return all;
}

Json bias_steps_json(const model::Model& model, const std::vector<std::string>& places) {
  const std::vector<model::EffectTerm> steps = found_steps(model);
  Json all = Json::array();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    all.push(bias_step_json(steps[i], places.empty() ? "" : places.at(i)));
  }
  return all;
}

}  // namespace fogcomp::findings
