#include "findings/json.hpp"

#include "model/catalogue.hpp"

namespace fogcomp::findings {

void set_parameters(Json& object, const model::EffectTerm& term) {
  const model::TermInfo info = model::info_of(term);
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    object.set(info.parameters[i].name, model::shape_value(term, i).value);
  }
}

void set_coefficients(Json& object, const model::EffectTerm& term) {
  const model::TermInfo info = model::info_of(term);
  for (std::size_t i = 0; i < term.coefficients_dph.size(); ++i) {
    object.set(info.coefficients[i].symbol, model::natural_coefficient(term, i).value);
  }
}

}  // namespace fogcomp::findings
