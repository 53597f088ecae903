#include "core/effects/effect_check.hpp"

namespace fog {

bool any_effect_fits(std::size_t id, const EffectParameters& effect, std::size_t constant_count) {
  return effect_fits<kAllEffects>(id, effect, constant_count);
}

}  // namespace fog
