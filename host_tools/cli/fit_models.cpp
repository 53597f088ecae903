#include "cli/fit_models.hpp"

#include <algorithm>

#include "cli/fit_recordings.hpp"
#include "research/comparator.hpp"
#include "research/polynomial.hpp"
#include "support/input_error.hpp"

namespace fogcomp::cli {
namespace {

// Models with a trainer here have a network on the bias alone, of (temperature, temperature rate).
struct Preset {
  const char* name;
  const char* effects;  // "" where --effects says
  const char* trainer;  // "" for no network, "any" where --trainer says
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

void refuse(const Option& option, const std::string& model) {
  if (!option.given()) return;
  throw InputError("--" + option.name,
                   "is settled by --model " + model + "; leave one of the two out");
}

const Preset& find_preset(const std::string& name) {
  for (const Preset& preset : kPresets) {
    if (name == preset.name) return preset;
  }
  find_comparator(name);  // names the nearest where there is none
  throw InputError("--model " + name,
                   "no model file or board can carry it; fogcomp paper compares it with those that "
                   "can");
}

}  // namespace

WantedModel wanted_model(const FitOptions& options) {
  WantedModel model;
  model.network = options.training.value();
  if (!options.model.given()) {
    model.effects = options.effects.required();
    return model;
  }
  const std::string name = options.model.value();
  const Preset& preset = find_preset(name);
  const std::string trainer = preset.trainer;
  model.order_by_validation = preset.order_by_validation;
  model.effects = preset.effects;
  if (model.effects.empty()) {
    model.effects = options.effects.required();
  } else {
    refuse(options.effects, name);
  }
  if (trainer != kOpen) refuse(options.training.trainer, name);
  if (trainer.empty()) {
    refuse(options.training.network, name);
    return model;
  }
  model.network_is_the_model = trainer != kOpen;
  if (model.network_is_the_model) model.network.trainer = trainer;
  if (!options.training.network.given()) model.network.hidden = kUsualHidden;
  return model;
}

std::vector<std::string> fit_model_names() {
  std::vector<std::string> names;
  for (const Preset& preset : kPresets) names.emplace_back(preset.name);
  return names;
}

std::string fit_model_list() {
  return join(fit_model_names(), ", ");
}

void choose_order(std::vector<EffectTerm>& terms, const Rows& rows) {
  const auto found = std::find_if(terms.begin(), terms.end(), [](const EffectTerm& term) {
    return term.name == "bias_temperature";
  });
  found->parameters[0] = Polynomial::best_order(temperature_of(rows), rows.drift_dph);
}

}  // namespace fogcomp::cli
