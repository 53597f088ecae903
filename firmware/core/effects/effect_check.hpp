#pragma once

#include <cstddef>

#include "core/effects/effect_parameters.hpp"
#include "core/effects/registry.hpp"

namespace fog {

namespace detail {

// Checks the number of constants, their ranges (the effect's own check) and the number of
// coefficients, which must equal that of the regressors.
template <class Effect>
bool fits(const EffectParameters& effect, std::size_t constant_count) {
  if (constant_count != Effect::constant_fractions.size()) return false;
  if (!Effect::constants_valid(effect.constants)) return false;
  return Effect(effect.constants).regressor_count() == effect.coefficients.size;
}

// An effect that the image does not have has no check: the table is refused for enabling it.
template <EffectMask kCompiled, class Effect>
bool fits_if_compiled(const EffectParameters& effect, std::size_t constant_count) {
  if constexpr ((kCompiled & bit_of(Effect::description)) != 0U) {
    return fits<Effect>(effect, constant_count);
  } else {
    return true;
  }
}

template <EffectMask kCompiled, template <class> class... Effects>
bool effect_fits(std::size_t id, const EffectParameters& effect, std::size_t constant_count,
                 EffectList<Effects...> /*list*/) {
  return ((Effects<BoardNumbers>::description.id != id ||
           fits_if_compiled<kCompiled, Effects<BoardNumbers>>(effect, constant_count)) &&
          ...);
}

}  // namespace detail

/// The check of an image with the effects in kCompiled.
template <EffectMask kCompiled>
bool effect_fits(std::size_t id, const EffectParameters& effect, std::size_t constant_count) {
  return detail::effect_fits<kCompiled>(id, effect, constant_count, Registry{});
}

}  // namespace fog
