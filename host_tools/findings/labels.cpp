#include "findings/labels.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "model/catalogue.hpp"

namespace fogcomp::findings {
namespace {

struct Label {
  const char* name;
  const char* label;
};

constexpr Label kVariables[] = {
    {"temperature_rate", "temperature rate"},
    {"temperature_degc x temperature_rate", "temperature x temperature rate"},
    {"time_s", "time"},
};

constexpr Label kFigures[] = {
    {"rows", "rows of the fit"},
    {"noise_dprh", "angle random walk, deg/sqrt(h)"},
    {"fit_raw_std_dph", "rms left by a constant, fit, deg/h"},
    {"fit_rms_dph", "rms left by the model, fit, deg/h"},
    {"fit_floor_dph", "noise floor, fit, deg/h"},
    {"fit_drift_dph", "drift left, fit, deg/h"},
    {"fit_misfit", "misfit of the fit (1: noise alone)"},
    {"fit_outliers", "rows left out of the fit: outliers"},
    {"network_hidden", "neurons of the network"},
    {"holdout_raw_std_dph", "std before, holdout, deg/h"},
    {"holdout_rms_dph", "rms left by the model, holdout, deg/h"},
    {"holdout_floor_dph", "noise floor, holdout, deg/h"},
    {"holdout_drift_dph", "drift left, holdout, deg/h"},
    {"holdout_offset_dph", "constant offset, holdout, deg/h"},
    {"holdout_outside", "part of a holdout outside the trained temperatures"},
    {"turn_on_bias_dph", "largest difference of the bias between runs, deg/h"},
    {"turn_on_sigma_dph", "its standard deviation, deg/h"},
    {"quantization_error_dph", "board's rounding error, deg/h"},
    {"network_error_dph", "board's rounding error of the network, deg/h"},
};

template <std::size_t size>
Text label_among(const Label (&labels)[size], const std::string& name) {
  const auto* const found = std::find_if(std::begin(labels), std::end(labels),
                                         [&](const Label& one) { return name == one.name; });
  return found == std::end(labels) ? Text() : words(found->label);
}

Text with_unit(const std::string& name, const std::string& unit) {
  const bool dimensionless = unit.empty() || unit == "1";
  return verbatim(name) + (dimensionless ? Text() : words(", " + unit));
}

// Label of "warm_up.tau": a shape parameter or a coefficient of an effect.
Text part_label(const model::CatalogueEntry& effect, const std::string& part) {
  const Text title = verbatim(std::string(effect.description.name)) + ": ";
  for (const fog::ParameterDescription& one : effect.parameters) {
    if (part == one.name) return title + with_unit(part, one.unit);
  }
  for (const fog::CoefficientDescription& one : effect.coefficients) {
    if (part == one.symbol) return title + with_unit(part, one.unit);
  }
  return {};
}

}  // namespace

Text input_label(fog::Input input) {
  const std::string unit = description_of(input).unit;
  return input_name(input) + words(", " + (unit[0] == 'u' ? "µ" + unit.substr(1) : unit));
}

Text input_name(fog::Input input) {
  return words(description_of(input).title);
}

Text variable_label(const std::string& variable) {
  const Text label = label_among(kVariables, variable);
  if (!label.empty()) return label;
  for (const fog::InputDescription& input : fog::kInputTable) {
    if (variable == input.column) return input_name(input.input);
  }
  return verbatim(variable);
}

Text figure_label(const std::string& figure) {
  const Text label = label_among(kFigures, figure);
  if (!label.empty()) return label;
  const std::size_t point = figure.find('.');
  for (const model::CatalogueEntry& effect : model::catalogue()) {
    if (point == std::string::npos || figure.substr(0, point) != effect.description.name) continue;
    return part_label(effect, figure.substr(point + 1));
  }
  return {};
}

}  // namespace fogcomp::findings
