#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/effects/effect.hpp"
#include "core/signal/quantities.hpp"
#include "core/signal/span.hpp"

// What a model table says of effects, whichever there are: whoever needs no more is not compiled
// again for another list of effects (registry.hpp).
namespace fog {

/// Constants of an effect that the model does not use: every constructor accepts zeros.
inline constexpr std::array<std::int32_t, 16> kZeroConstants{};

/// One effect as stored in the model table.
struct EffectParameters {
  const std::int32_t* constants = kZeroConstants.data();
  Span<const std::int32_t> coefficients;  ///< one per regressor; empty: the effect is off

  bool enabled() const { return coefficients.size != 0; }
};

/// Fractional bits of coefficients: at least those of Rate, more if their size allows.
constexpr int kMinCoefficientFraction = Rate::fractional_bits;
constexpr int kMaxCoefficientFraction = 40;

struct EffectsParameters {
  std::array<EffectParameters, kMaxEffects> by_id{};
  int coefficient_fraction = 0;  ///< fractional bits of every coefficient, deg/h

  EffectMask enabled() const {
    EffectMask mask = 0;
    for (std::size_t id = 0; id < kMaxEffects; ++id) {
      if (by_id[id].enabled()) mask |= EffectMask{1} << id;
    }
    return mask;
  }
};

/// Whether an effect of a table can be constructed in this image.
using EffectCheck = bool (*)(std::size_t id, const EffectParameters& effect,
                             std::size_t constant_count);

/// The check for all effects that a board can run.
bool any_effect_fits(std::size_t id, const EffectParameters& effect, std::size_t constant_count);

}  // namespace fog
