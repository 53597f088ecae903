#include "simulation/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::simulation {

Parameters::Parameters(std::string owner, const std::vector<ParameterSpec>& specs)
    : owner_(std::move(owner)), specs_(&specs), set_(specs.size(), false) {
  for (const ParameterSpec& spec : specs) values_.push_back(spec.default_value);
}

std::size_t Parameters::index_of(const std::string& name) const {
  const auto found = std::find_if(specs_->begin(), specs_->end(),
                                  [&](const ParameterSpec& spec) { return spec.name == name; });
  return static_cast<std::size_t>(found - specs_->begin());
}

namespace {

std::string listed(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

// Index of the choice. `where`, `name`: for errors.
double choice_of(const ParameterSpec& spec, const std::string& value, const std::string& where,
                 const std::string& name) {
  const auto choice = std::find(spec.choices.begin(), spec.choices.end(), value);
  if (choice == spec.choices.end()) {
    throw InputError(where, name + " '" + value + "' is not one of " + listed(spec.choices) +
                                did_you_mean(value, spec.choices));
  }
  return static_cast<double>(choice - spec.choices.begin());
}

double number_of(const ParameterSpec& spec, const std::string& value, const std::string& where,
                 const std::string& name) {
  const auto number = parse_number(value);
  if (!number || *number < spec.min || *number > spec.max) {
    throw InputError(where, name + " '" + value + "' is not a number from " +
                                format("%g to %g", spec.min, spec.max) +
                                (spec.unit.empty() ? "" : " " + spec.unit));
  }
  if (spec.whole && *number != std::floor(*number)) {
    throw InputError(where, name + " '" + value + "' is not a whole number");
  }
  return *number;
}

}  // namespace

void Parameters::assign(const std::string& where, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) {
    throw InputError(where, "'" + assignment + "' is not of the form name=value");
  }
  const std::string name(trim(assignment.substr(0, equals)));
  const std::string value(trim(assignment.substr(equals + 1)));
  const std::size_t index = index_of(name);
  if (index == specs_->size()) {
    std::vector<std::string> names;
    for (const ParameterSpec& spec : *specs_) names.push_back(spec.name);
    throw InputError(where, owner_ + " has no parameter '" + name + "'" +
                                did_you_mean(name, names) + "; it has " + listed(names));
  }
  const ParameterSpec& spec = (*specs_)[index];
  const std::string full_name = owner_ + ": " + name;
  values_[index] = spec.choices.empty() ? number_of(spec, value, where, full_name)
                                        : choice_of(spec, value, where, full_name);
  set_[index] = true;
}

double Parameters::operator[](const std::string& name) const {
  const std::size_t index = index_of(name);
  if (index == specs_->size()) throw std::logic_error(owner_ + " has no parameter " + name);
  return values_[index];
}

bool Parameters::was_set(const std::string& name) const {
  const std::size_t index = index_of(name);
  return index < specs_->size() && set_[index];
}

std::string Parameters::text() const {
  std::string text;
  for (std::size_t i = 0; i < specs_->size(); ++i) {
    text +=
        (text.empty() ? "" : " ") + (*specs_)[i].name + "=" + value_text((*specs_)[i], values_[i]);
  }
  return text;
}

std::string value_text(const ParameterSpec& spec, double value) {
  if (!spec.choices.empty()) return spec.choices[static_cast<std::size_t>(value)];
  return format("%.10g", value);
}

}  // namespace fogcomp::simulation
