#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "board/table_parts.hpp"
#include "model/catalogue.hpp"
#include "model/model.hpp"
#include "support/sample_models.hpp"
#include "support/text.hpp"

// Terms of models for tests: effects at the size that they have in tactical and navigation gyros.
namespace fog::test {

/// A term from coefficients in the natural units of the catalogue. Parameters that are not given
/// have their defaults.
inline fogcomp::model::EffectTerm natural_term(const std::string& name,
                                               const std::vector<double>& parameters,
                                               const std::vector<double>& coefficients) {
  const fogcomp::model::CatalogueEntry& entry = fogcomp::model::find_effect(name);
  fogcomp::model::EffectTerm term;
  term.name = name;
  for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
    const double value =
        i < parameters.size() ? parameters[i] : entry.parameters[i].default_milli / 1000.0;
    term.parameters.push_back({value});
  }
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    const CoefficientDescription& description = entry.coefficients[i];
    const double dph = std::ldexp(coefficients[i], description.scale_log2) / description.per_unit;
    term.coefficients_dph.emplace_back(dph, 0.01 * std::abs(dph));
  }
  return term;
}

/// An expression of 0.02 deg/h at its largest over usual ranges of its signals.
inline fogcomp::model::EffectTerm written_term(const std::string& definition) {
  fogcomp::model::EffectTerm term = fogcomp::model::expression_term(definition);
  term.expression->ranges = {{{-60, 100},
                              {-32, 32},
                              {0, 3600000},
                              {-100, 100},
                              {-70, 110},
                              {-500, 500},
                              {0, 5000},
                              {4, 6},
                              {0, 20}}};
  fogcomp::model::Model model = paper_like_model();
  term.expression->scale_log2 =
      std::ilogb(fogcomp::board::compile_expression(term, model, 1).max) - 1;
  term.coefficients_dph = {{0.005, 0.0001}};
  return term;
}

/// An effect as the example in its description has it.
inline fogcomp::model::EffectTerm example_term(const fogcomp::model::CatalogueEntry& entry) {
  const std::string name = entry.description.name;
  std::vector<double> parameters;
  std::vector<double> coefficients;
  for (const std::string& setting : fogcomp::split(entry.description.example, ' ')) {
    const std::string::size_type equals = setting.find('=');
    const std::string what = setting.substr(0, equals);
    const bool of_shape = parameters.size() < entry.parameters.size() &&
                          what == entry.parameters[parameters.size()].name;
    const bool in_order = of_shape || (coefficients.size() < entry.coefficients.size() &&
                                       what == entry.coefficients[coefficients.size()].symbol);
    const auto value = fogcomp::parse_number(in_order ? setting.substr(equals + 1) : "");
    if (!value) {
      throw std::invalid_argument(name +
                                  ": its example must be parameters and then coefficients, "
                                  "in order, NAME=VALUE: " +
                                  setting);
    }
    (of_shape ? parameters : coefficients).push_back(*value);
  }
  return natural_term(name, parameters, coefficients);
}

/// Every effect that a board can have, as in its example.
inline std::vector<fogcomp::model::EffectTerm> typical_terms() {
  std::vector<fogcomp::model::EffectTerm> terms;
  for (const fogcomp::model::CatalogueEntry& entry : fogcomp::model::catalogue()) {
    if (entry.description.host_only == nullptr) terms.push_back(example_term(entry));
  }
  return terms;
}

/// The sample model and expressions with most of the operations there are.
inline fogcomp::model::Model expressions_model() {
  fogcomp::model::Model model = paper_like_model();
  for (const char* text : {"a = T^3/(2+abs(dTdt))", "b = play(lag(T,300),4)*sin(t/9)",
                           "c = exp(-T/30)-min(tanh(W),max(T,3))"}) {
    model.terms.push_back(written_term(text));
  }
  return model;
}

/// All typical terms, and the sample model's network.
inline fogcomp::model::Model all_effects_model() {
  fogcomp::model::Model model = paper_like_model();
  model.terms = typical_terms();
  return model;
}

}  // namespace fog::test
