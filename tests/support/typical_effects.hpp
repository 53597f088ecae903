#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "model/catalogue.hpp"
#include "model/model.hpp"
#include "quantization/expression_code.hpp"
#include "support/sample_models.hpp"

// Every effect of the board at the size that effects have in tactical and navigation gyros.
namespace fog::test {

/// A term from coefficients in the natural units of the catalogue. Parameters that are not given
/// have their defaults.
inline fogcomp::EffectTerm natural_term(const std::string& name,
                                        const std::vector<double>& parameters,
                                        const std::vector<double>& coefficients) {
  const fogcomp::CatalogueEntry& entry = fogcomp::find_effect(name);
  fogcomp::EffectTerm term;
  term.name = name;
  term.parameters = parameters;
  while (term.parameters.size() < entry.parameters.size()) {
    term.parameters.push_back(entry.parameters[term.parameters.size()].default_milli / 1000.0);
  }
  term.identified.assign(term.parameters.size(), false);
  term.parameter_sigma.assign(term.parameters.size(), 0);
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    const CoefficientDescription& description = entry.coefficients[i];
    term.coefficients_dph.push_back(std::ldexp(coefficients[i], description.scale_log2) /
                                    description.per_unit);
    term.sigma_dph.push_back(0.01 * std::abs(term.coefficients_dph.back()));
  }
  return term;
}

/// An expression of 0.02 deg/h at its largest over usual ranges of its signals.
inline fogcomp::EffectTerm written_term(const std::string& definition) {
  fogcomp::EffectTerm term = fogcomp::expression_term(definition);
  term.expression->ranges = {{{-60, 100},
                              {-32, 32},
                              {0, 3600000},
                              {-100, 100},
                              {-70, 110},
                              {-500, 500},
                              {0, 5000},
                              {4, 6},
                              {0, 20}}};
  fogcomp::Model model = paper_like_model();
  term.expression->scale_log2 = std::ilogb(fogcomp::compile_expression(term, model, 1).most) - 1;
  term.coefficients_dph = {0.005};
  term.sigma_dph = {0.0001};
  return term;
}

inline std::vector<fogcomp::EffectTerm> typical_terms() {
  return {natural_term("bias", {}, {0.72}),
          natural_term("bias_temperature", {3}, {-3.5e-4, -3.2e-5, 1e-7}),
          natural_term("temperature_rate", {}, {0.136}),
          natural_term("shupe", {120}, {1.0}),
          natural_term("thermal_lag", {960}, {0.14}),
          natural_term("temperature_rate_product", {}, {1e-3}),
          natural_term("axial_gradient", {30}, {0.9, 0.1}),
          natural_term("polarization_ripple", {13, 4.8, 0.05}, {0.02, -0.03, 0.005, 0.004}),
          natural_term("thermal_hysteresis", {3, 10}, {0.03, 0.02}),
          natural_term("glass_transition", {-20, 4}, {0.1, 0.14}),
          natural_term("scale_factor_temperature", {}, {300}),
          natural_term("warm_up", {1200}, {0.3}),
          natural_term("aging", {3600}, {0.02}),
          natural_term("magnetic", {}, {0.005, 5e-6}),
          natural_term("vibration", {}, {0.00125}),
          natural_term("light_power", {}, {0.1})};
}

/// The sample model and expressions with most of the operations there are.
inline fogcomp::Model expressions_model() {
  fogcomp::Model model = paper_like_model();
  for (const char* text : {"a = T^3/(2+abs(dTdt))", "b = play(lag(T,300),4)*sin(t/9)",
                           "c = exp(-T/30)-min(tanh(W),max(T,3))"}) {
    model.terms.push_back(written_term(text));
  }
  return model;
}

/// All typical terms, and the sample model's network.
inline fogcomp::Model all_effects_model() {
  fogcomp::Model model = paper_like_model();
  model.terms = typical_terms();
  return model;
}

}  // namespace fog::test
