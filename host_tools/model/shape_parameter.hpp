#pragma once

#include <algorithm>
#include <vector>

#include "core/effects/effect.hpp"
#include "model/model.hpp"

namespace fogcomp::model {

/// A shape parameter that a fit may change.
struct ShapeParameter {
  std::size_t term = 0;
  std::size_t index = 0;
  double min = 0;
  double max = 0;
  fog::Scale scale = fog::Scale::linear;

  /// Position in the range, 0..1, on its scale; and back, clipped to the range.
  double to_unit(double value) const;
  double from_unit(double unit) const;
  /// The same of the parameter in a term.
  double unit_in(const EffectTerm& place) const { return to_unit(place.parameters[index].value); }
  void set_unit(EffectTerm& place, double unit) const {
    place.parameters[index].value = from_unit(unit);
  }
  /// d value / d unit.
  double slope(double value) const;
};

/// Derivative of `drift_of(term)`, a number or a vector, by the parameter's position in its range.
template <class DriftOf>
auto derivative_by_unit(const ShapeParameter& shape, EffectTerm term, const DriftOf& drift_of) {
  constexpr double kStep = 1e-4;
  const double unit = shape.unit_in(term);
  const double up = std::min(unit + kStep, 1.0);
  const double down = std::max(unit - kStep, 0.0);
  shape.set_unit(term, up);
  auto change = drift_of(term);
  shape.set_unit(term, down);
  change -= drift_of(term);
  change /= up - down;
  return change;
}

std::vector<ShapeParameter> shape_parameters(const std::vector<EffectTerm>& terms);

/// Fixes the shapes of all terms but those at the positions `free`.
std::vector<EffectTerm> with_fixed_shapes(std::vector<EffectTerm> terms,
                                          const std::vector<std::size_t>& free = {});

}  // namespace fogcomp::model
