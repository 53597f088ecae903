#pragma once

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

std::vector<ShapeParameter> shape_parameters(const std::vector<EffectTerm>& terms);

/// Fixes the shapes of all terms but those at the positions `free`.
std::vector<EffectTerm> with_fixed_shapes(std::vector<EffectTerm> terms,
                                          const std::vector<std::size_t>& free = {});

}  // namespace fogcomp::model
