#include "model/shape_parameter.hpp"

#include <algorithm>
#include <cmath>

#include "model/catalogue.hpp"

namespace fogcomp::model {

double ShapeParameter::to_unit(double value) const {
  switch (scale) {
    case fog::Scale::logarithmic:
      return std::log(value / min) / std::log(max / min);
    case fog::Scale::frequency:
      return (1 / min - 1 / value) / (1 / min - 1 / max);
    case fog::Scale::linear:
    case fog::Scale::place:
    case fog::Scale::whole:
      break;
  }
  return (value - min) / (max - min);
}

double ShapeParameter::from_unit(double unit) const {
  const double u = std::clamp(unit, 0.0, 1.0);
  switch (scale) {
    case fog::Scale::logarithmic:
      return min * std::pow(max / min, u);
    case fog::Scale::frequency:
      return 1 / (1 / min - u * (1 / min - 1 / max));
    case fog::Scale::linear:
    case fog::Scale::place:
    case fog::Scale::whole:
      break;
  }
  return min + u * (max - min);
}

double ShapeParameter::slope(double value) const {
  switch (scale) {
    case fog::Scale::logarithmic:
      return value * std::log(max / min);
    case fog::Scale::frequency:
      return value * value * (1 / min - 1 / max);
    case fog::Scale::linear:
    case fog::Scale::place:
    case fog::Scale::whole:
      break;
  }
  return max - min;
}

std::vector<ShapeParameter> shape_parameters(const std::vector<EffectTerm>& terms) {
  std::vector<ShapeParameter> parameters;
  for (std::size_t term = 0; term < terms.size(); ++term) {
    if (is_event(terms[term])) continue;
    const TermInfo entry = info_of(terms[term]);
    for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
      const Parameter& own = terms[term].parameters[i];
      if (!own.identified || entry.parameters[i].is_reference) continue;
      const ShapeBounds bounds = own.bounds.are_given() ? own.bounds : entry.parameters[i].bounds;
      parameters.push_back({term, i, bounds.min, bounds.max, entry.parameters[i].scale});
    }
  }
  return parameters;
}

std::vector<EffectTerm> with_fixed_shapes(std::vector<EffectTerm> terms,
                                          const std::vector<std::size_t>& free) {
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (std::find(free.begin(), free.end(), i) != free.end()) continue;
    for (Parameter& parameter : terms[i].parameters) parameter.identified = false;
  }
  return terms;
}

}  // namespace fogcomp::model
