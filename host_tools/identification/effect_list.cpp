#include "identification/effect_list.hpp"

#include <algorithm>
#include <cmath>

#include "model/catalogue.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp {
namespace {

void set_parameter(EffectTerm& term, const CatalogueEntry& entry, const std::string& setting) {
  const std::string where = "effect '" + term.name + "'";
  const std::size_t equals = setting.find('=');
  const std::string name = setting.substr(0, equals);
  std::vector<std::string> names;
  for (const auto& parameter : entry.parameters) names.emplace_back(parameter.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    std::string known;
    for (const std::string& one : names) known += (known.empty() ? "" : ", ") + one;
    throw InputError(where, "has no parameter '" + name + "'" + did_you_mean(name, names) +
                                "; it has " + (known.empty() ? "none" : known));
  }
  const auto index = static_cast<std::size_t>(found - names.begin());
  const fog::ParameterDescription& description = entry.parameters[index];
  const auto value =
      equals == std::string::npos ? std::nullopt : parse_number(setting.substr(equals + 1));
  const double least = description.least_milli / 1000.0;
  const double most = description.most_milli / 1000.0;
  if (!value || *value < least || *value > most ||
      (description.whole && *value != std::round(*value))) {
    throw InputError(where,
                     format("%s must be a %snumber from %g to %g %s", name.c_str(),
                            description.whole ? "whole " : "", least, most, description.unit));
  }
  term.parameters[index] = *value;
  term.identified[index] = false;
}

// Commas separate effects, and further parameters of one effect: a part with '=' but without ':'
// belongs to the effect before it.
std::vector<std::vector<std::string>> split_effects(const std::string& list) {
  std::vector<std::vector<std::string>> effects;
  for (const std::string& part : split(list, ',')) {
    const std::size_t colon = part.find(':');
    if (colon == std::string::npos && part.find('=') != std::string::npos && !effects.empty()) {
      effects.back().push_back(part);
      continue;
    }
    effects.push_back({part.substr(0, colon)});
    if (colon != std::string::npos) effects.back().push_back(part.substr(colon + 1));
  }
  return effects;
}

}  // namespace

std::vector<EffectTerm> parse_effects(const std::string& list) {
  std::vector<EffectTerm> terms;
  for (const auto& words : split_effects(list)) {
    const CatalogueEntry& entry = find_effect(words[0]);
    EffectTerm term;
    term.name = words[0];
    for (const auto& parameter : entry.parameters) {
      term.parameters.push_back(parameter.default_milli / 1000.0);
      term.identified.push_back(!parameter.whole && parameter.default_milli != 0);
      term.parameter_sigma.push_back(0);
    }
    for (std::size_t i = 1; i < words.size(); ++i) set_parameter(term, entry, words[i]);
    const bool twice = std::any_of(terms.begin(), terms.end(), [&](const EffectTerm& other) {
      return other.name == term.name;
    });
    if (twice) throw InputError("effect '" + term.name + "'", "is listed twice; list it once");
    terms.push_back(term);
  }
  if (terms.empty()) throw InputError("--effects", "names no effect; try --effects bias");
  return terms;
}

}  // namespace fogcomp
