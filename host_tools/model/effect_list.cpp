#include "model/effect_list.hpp"

#include <algorithm>
#include <cmath>

#include "model/catalogue.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::model {
namespace {

std::string trimmed(const std::string& text) {
  return std::string(trim(text));
}

// Position of a parameter in its effect's list.
std::size_t parameter_index(const std::string& where, const CatalogueEntry& entry,
                            const std::string& name) {
  std::vector<std::string> names;
  for (const auto& parameter : entry.parameters) names.emplace_back(parameter.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  throw InputError(where, "has no parameter '" + name + "'" + did_you_mean(name, names) +
                              "; it has " + (names.empty() ? "none" : join(names, ", ")));
}

// `?` or `?[min,max]`: to be identified, within the catalogue's bounds or narrower ones.
void identify_parameter(EffectTerm& term, const CatalogueEntry& entry, std::size_t index,
                        const std::string& range) {
  const std::string where = "effect '" + term.name + "'";
  const fog::ParameterDescription& description = entry.parameters[index];
  if (description.scale == fog::Scale::whole) {
    throw InputError(where, format("%s is a whole number, which a fit does not search for; give "
                                   "its value",
                                   description.name));
  }
  Parameter& parameter = term.parameters[index];
  parameter.identified = true;
  if (is_reference(description)) {
    if (range.empty()) return;
    throw InputError(where,
                     "takes its reference from the rows; leave the bounds out, or give its value");
  }
  ShapeBounds bounds = catalogue_bounds(entry, index);
  if (!range.empty()) {
    const std::size_t comma = range.find(',');
    const bool bracketed = range.front() == '[' && range.back() == ']' && range.size() > 2 &&
                           comma != std::string::npos;
    const auto min = bracketed ? parse_number(trimmed(range.substr(1, comma - 1))) : std::nullopt;
    const auto max = bracketed
                         ? parse_number(trimmed(range.substr(comma + 1, range.size() - comma - 2)))
                         : std::nullopt;
    if (!min || !max || !(bounds.min <= *min && *min < *max && *max <= bounds.max)) {
      throw InputError(where,
                       format("bounds of %s must be ?[min,max] within %g to %g%s", description.name,
                              bounds.min, bounds.max, unit_behind_number(description).c_str()));
    }
    bounds = {*min, *max};
  }
  parameter.bounds = range.empty() ? ShapeBounds{} : bounds;  // the catalogue's or the rows'
  if (bounds.min <= parameter.value && parameter.value <= bounds.max) return;
  parameter.value =
      bounds.min > 0 ? std::sqrt(bounds.min * bounds.max) : (bounds.min + bounds.max) / 2;
}

void set_parameter(EffectTerm& term, const CatalogueEntry& entry, const std::string& setting) {
  const std::string where = "effect '" + term.name + "'";
  const std::size_t colon = setting.find(':');
  if (colon != std::string::npos) {
    throw InputError(where, "needs a comma between its parameters: " + term.name + ":" +
                                setting.substr(0, colon) + "," + setting.substr(colon + 1));
  }
  const std::size_t equals = setting.find('=');
  const std::string name = trimmed(setting.substr(0, equals));
  const std::string given = equals == std::string::npos ? "" : trimmed(setting.substr(equals + 1));
  const std::size_t index = parameter_index(where, entry, name);
  if (!given.empty() && given[0] == '?') {
    identify_parameter(term, entry, index, trimmed(given.substr(1)));
    return;
  }
  const fog::ParameterDescription& description = entry.parameters[index];
  const auto value = parse_number(given);
  const double min = description.min_milli / 1000.0;
  const double max = description.max_milli / 1000.0;
  const bool whole = description.scale == fog::Scale::whole;
  if (!value || *value < min || *value > max || (whole && *value != std::round(*value))) {
    throw InputError(
        where,
        format("%s must be a %snumber from %g to %g%s%s", name.c_str(), whole ? "whole " : "", min,
               max, unit_behind_number(description).c_str(), whole ? "" : ", or ? to identify it"));
  }
  term.parameters[index].value = *value;
  term.parameters[index].identified = false;
}

// Splits at commas outside brackets.
std::vector<std::string> split_list(const std::string& list) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : list) {
    depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (c == ',' && depth == 0) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  for (std::string& part : parts) part = trimmed(part);
  return parts;
}

// Commas separate effects, and further parameters of one effect: a part with '=' but without ':'
// belongs to the effect before it.
std::vector<std::vector<std::string>> split_effects(const std::string& list) {
  std::vector<std::vector<std::string>> effects;
  for (const std::string& part : split_list(list)) {
    const std::size_t colon = part.find(':');
    if (colon == std::string::npos && part.find('=') != std::string::npos && !effects.empty()) {
      effects.back().push_back(part);
      continue;
    }
    effects.push_back({trimmed(part.substr(0, colon))});
    if (colon != std::string::npos) effects.back().push_back(trimmed(part.substr(colon + 1)));
  }
  return effects;
}

bool has_name(const std::vector<EffectTerm>& terms, const std::string& name) {
  return std::any_of(terms.begin(), terms.end(),
                     [&](const EffectTerm& term) { return term.name == name; });
}

}  // namespace

std::vector<EffectTerm> grown_terms(const EffectTerm& own) {
  std::vector<EffectTerm> more;
  if (own.expression) return more;
  const CatalogueEntry& entry = find_effect(own.name);
  for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
    const fog::ParameterDescription& parameter = entry.parameters[i];
    EffectTerm term = own;
    if (parameter.scale == fog::Scale::whole &&
        own.parameters[i].value < parameter.max_milli / 1000.0) {
      term.parameters[i].value += 1;
      more.push_back(term);
    } else if (is_optional_part(parameter) && own.parameters[i].value == 0) {
      term.parameters[i].identified = true;
      term.parameters[i].value = catalogue_bounds(entry, i).min;
      more.push_back(term);
    }
  }
  return more;
}

std::vector<std::string> possible_refinements(const EffectTerm& own) {
  std::vector<std::string> settings;
  if (own.expression) return settings;
  const CatalogueEntry& entry = find_effect(own.name);
  for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
    const fog::ParameterDescription& parameter = entry.parameters[i];
    const bool is_left_out = is_optional_part(parameter) && own.parameters[i].value == 0;
    const bool is_given =
        !own.parameters[i].identified && parameter.scale != fog::Scale::whole &&
        (is_optional_part(parameter) || parameter.not_given == fog::NotGiven::kept);
    if (is_left_out || is_given) settings.push_back(std::string(parameter.name) + "=?");
    const double most = parameter.max_milli / 1000.0;
    if (parameter.scale != fog::Scale::whole || own.parameters[i].value >= most) continue;
    settings.push_back(
        format("%s=%.0f", parameter.name, std::min(own.parameters[i].value + 2, most)));
  }
  return settings;
}

std::string free_name(const std::vector<EffectTerm>& terms, const std::string& name) {
  std::string free = name;
  for (int number = 2; has_name(terms, free); ++number)
    free = format("%s_%d", name.c_str(), number);
  return free;
}

void add_expression(std::vector<EffectTerm>& terms, const std::string& definition) {
  const EffectTerm term = expression_term(definition);
  if (has_name(terms, term.name)) {
    throw InputError("expression '" + definition + "'",
                     "has the name of another term; choose another");
  }
  terms.push_back(term);
}

std::vector<EffectTerm> parse_effects(const std::string& list) {
  std::vector<EffectTerm> terms;
  for (const auto& words : split_effects(list)) {
    const CatalogueEntry& entry = find_effect(words[0]);
    EffectTerm term;
    term.name = words[0];
    for (const auto& parameter : entry.parameters) {
      const bool identified =
          parameter.scale != fog::Scale::whole &&
          (parameter.not_given == fog::NotGiven::identified || is_reference(parameter));
      term.parameters.push_back({parameter.default_milli / 1000.0, 0, identified});
    }
    for (std::size_t i = 1; i < words.size(); ++i) set_parameter(term, entry, words[i]);
    if (has_name(terms, term.name)) {
      throw InputError("effect '" + term.name + "'", "is listed twice; list it once");
    }
    terms.push_back(term);
  }
  if (terms.empty()) throw InputError("--effects", "names no effect; try --effects bias");
  return terms;
}

}  // namespace fogcomp::model
