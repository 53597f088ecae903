#include "workflow/fit.hpp"

#include <algorithm>

#include "model/effect_list.hpp"
#include "research/comparator.hpp"
#include "research/polynomial.hpp"
#include "support/input_error.hpp"

namespace fogcomp::workflow {
namespace {

// A preset with a trainer is a network of (temperature, temperature rate) on the bias alone.
struct Preset {
  const char* name;
  const char* effects;  // "": from --effects
  const char* trainer;  // "": no network; "any": from --trainer
  bool order_by_validation;
};

constexpr const char* kOpen = "any";
constexpr int kUsualHidden = 10;

constexpr Preset kPresets[] = {
    {"polynomial", "bias,bias_temperature", "", true},
    {"rate-polynomial", "bias,bias_temperature,temperature_rate,temperature_rate_product", "",
     true},
    {"bp", "bias", "traingdx", false},
    {"ga-bp", "bias", "ga-bp", false},
    {"pso-bp", "bias", "pso-bp", false},
    {"effects", "", "", false},
    {"effects+network", "", kOpen, false},
};

void refuse(const char* option, bool given, const std::string& preset) {
  if (!given) return;
  throw InputError(option, "is determined by --model " + preset + "; leave one of the two out");
}

const Preset& find_preset(const std::string& name) {
  for (const Preset& preset : kPresets) {
    if (name == preset.name) return preset;
  }
  research::find_comparator(name);  // throws with the nearest name
  throw InputError("--model " + name,
                   "no model file or board can carry it; fogcomp paper compares it with those that "
                   "can");
}

}  // namespace

bool takes_effects(const std::optional<std::string>& preset) {
  return !preset || find_preset(*preset).effects == std::string();
}

WantedModel wanted_model(const FitRequest& request) {
  WantedModel model;
  network::NetworkSettings& network = model.network;
  network.hidden = request.hidden.value_or(0);
  network.hidden_activation = request.activation;
  network.trainer = request.trainer.value_or(network.trainer);
  network.training = request.training;
  model.effects = request.effects.value_or("");
  if (!request.preset) return model;
  const std::string& name = *request.preset;
  const Preset& preset = find_preset(name);
  const std::string trainer = preset.trainer;
  model.order_by_validation = preset.order_by_validation;
  if (!takes_effects(name)) {
    refuse("--effects", request.effects.has_value(), name);
    model.effects = preset.effects;
  }
  if (trainer != kOpen) refuse("--trainer", request.trainer.has_value(), name);
  if (trainer.empty()) {
    refuse("--network", request.hidden.has_value(), name);
    return model;
  }
  model.network_is_the_model = trainer != kOpen;
  if (model.network_is_the_model) network.trainer = trainer;
  if (!request.hidden) network.hidden = kUsualHidden;
  return model;
}

std::vector<model::EffectTerm> wanted_terms(const FitRequest& request) {
  std::vector<model::EffectTerm> terms = model::parse_effects(wanted_model(request).effects);
  model::refuse_events(terms);
  for (const std::string& definition : request.expressions)
    model::add_expression(terms, definition);
  return terms;
}

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const Preset& preset : kPresets) names.emplace_back(preset.name);
  return names;
}

std::vector<model::EffectTerm> with_best_order(std::vector<model::EffectTerm> terms,
                                               const series::Rows& rows) {
  const auto found = std::find_if(terms.begin(), terms.end(), [](const model::EffectTerm& term) {
    return term.name == "bias_temperature";
  });
  found->parameters[0].value =
      research::Polynomial::best_order(research::temperature_of(rows), rows.drift_dph);
  return terms;
}

}  // namespace fogcomp::workflow
