#include "fit/effect_change.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "model/shape_parameter.hpp"
#include "network/perceptron.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {
namespace {

model::EffectTerm parse_one(const std::string& effect) {
  if (effect.empty()) throw InputError("effect", "is not named; fogcomp effects lists them");
  const std::vector<model::EffectTerm> terms = model::parse_effects(effect);
  if (terms.size() != 1) {
    throw InputError("effect '" + effect + "'", "is more than one; add them one after the other");
  }
  model::refuse_events(terms);
  return terms[0];
}

// All parameters, in the syntax of `fit --effects`.
std::string settings_of(const model::EffectTerm& term) {
  const model::CatalogueEntry& entry = model::find_effect(term.name);
  std::string text;
  for (std::size_t i = 0; i < term.parameters.size(); ++i) {
    text += text.empty() ? ":" : ",";
    text += entry.parameters[i].name;
    text += term.parameters[i].identified ? "=?" : format("=%.17g", term.parameters[i].value);
  }
  return text;
}

// What was given or searched for is so again, unless `effect` sets it: of two settings of a
// parameter the last counts.
model::EffectTerm with_settings(const model::EffectTerm& old, const std::string& effect) {
  const std::size_t colon = effect.find(':');
  std::string settings = settings_of(old);
  if (colon != std::string::npos) {
    settings += (settings.empty() ? ":" : ",") + effect.substr(colon + 1);
  }
  model::EffectTerm term = parse_one(old.name + settings);
  for (const model::ShapeParameter& shape : model::shape_parameters({term})) {
    const double value = old.parameters[shape.index].value;
    if (shape.min <= value && value <= shape.max) term.parameters[shape.index].value = value;
  }
  return term;
}

// `network` or `network:hidden=N`.
std::optional<int> hidden_of(const std::string& effect) {
  constexpr int kUsual = 4;
  const std::string name = kNetworkName;
  if (effect.substr(0, effect.find(':')) != name) return std::nullopt;
  const std::string given = effect.substr(name.size());
  const std::string setting = ":hidden=";
  if (given.empty()) return kUsual;
  const bool is_setting = given.rfind(setting, 0) == 0;
  const std::optional<double> hidden =
      is_setting ? parse_number(given.substr(setting.size())) : std::nullopt;
  if (!hidden || *hidden < 1 || *hidden > network::kMaxTrainedHidden ||
      *hidden != std::floor(*hidden)) {
    throw InputError("'" + effect + "'", format("is no network; write network:hidden=N, 1 to %d",
                                                network::kMaxTrainedHidden));
  }
  return static_cast<int>(*hidden);
}

}  // namespace

EffectChange change_effect(const std::vector<model::EffectTerm>& terms, const std::string& effect) {
  EffectChange change{terms, {}, effect};
  const model::EffectTerm added = parse_one(effect);
  const auto old = std::find_if(terms.begin(), terms.end(), [&](const model::EffectTerm& term) {
    return term.name == added.name;
  });
  if (old == terms.end()) {
    change.changed = {terms.size()};
    change.terms.push_back(added);
    return change;
  }
  const auto place = static_cast<std::size_t>(old - terms.begin());
  change.changed = {place};
  const std::vector<model::EffectTerm> grown = model::grown_terms(*old);
  if (effect.find(':') == std::string::npos && !grown.empty()) {
    change.terms[place] = grown.front();
    return change;
  }
  const model::EffectTerm changed = with_settings(*old, effect);
  const bool has_bounds = effect.find('[') != std::string::npos;
  if (!has_bounds && settings_of(changed) == settings_of(*old) && changed.shape() == old->shape()) {
    throw InputError(
        "effect '" + effect + "'",
        effect.find(':') == std::string::npos
            ? "is in the model already; name a parameter to change, or another effect"
            : "is in the model with this value already; give another value or ?[min,max]");
  }
  change.terms[place] = changed;
  return change;
}

EffectChange change_effects(const std::vector<model::EffectTerm>& terms,
                            const std::vector<std::string>& effects) {
  EffectChange all{terms, {}, ""};
  if (effects.size() == 1) {
    if (const std::optional<int> hidden = hidden_of(effects[0])) {
      return {terms, {}, effects[0], *hidden};
    }
  }
  for (const std::string& effect : effects) {
    if (hidden_of(effect)) {
      throw InputError(effect,
                       "is trained on what all effects leave; add it by itself, after them");
    }
    const EffectChange one = change_effect(all.terms, effect);
    const std::size_t place = one.changed.front();
    if (std::find(all.changed.begin(), all.changed.end(), place) != all.changed.end()) {
      throw InputError("effect '" + effect + "'", "is named twice; name it once");
    }
    all.terms = one.terms;
    all.changed.push_back(place);
    all.what += (all.what.empty() ? "" : ", ") + effect;
  }
  return all;
}

EffectChange change_cuts(const std::vector<model::EffectTerm>& terms,
                         const std::vector<recording::Cut>& cuts) {
  return {terms, {}, "", 0, cuts};
}

EffectChange change_expression(const std::vector<model::EffectTerm>& terms,
                               const std::string& definition) {
  EffectChange change{terms, {terms.size()}, definition};
  model::add_expression(change.terms, definition);
  return change;
}

}  // namespace fogcomp::fit
