#pragma once

#include <cstddef>

#include "core/effects/bias.hpp"
#include "core/effects/bias_temperature.hpp"
#include "core/effects/effect.hpp"
#include "core/effects/temperature_rate.hpp"
#include "core/signal/quantities.hpp"

namespace fog {

template <template <class> class... Effects>
struct EffectList {};

/// Every effect there is. One line here makes an effect known to fit, export, replay and the board.
using Registry = EffectList<effects::Bias,             //
                            effects::BiasTemperature,  //
                            effects::TemperatureRate>;

/// The longest list of regressors that any effect has.
template <template <class> class... Effects>
constexpr std::size_t most_regressors(EffectList<Effects...> /*list*/) {
  std::size_t most = 0;
  ((most = Effects<BoardNumbers>::coefficients.size() > most
               ? Effects<BoardNumbers>::coefficients.size()
               : most),
   ...);
  return most;
}

template <template <class> class... Effects>
constexpr EffectMask mask_of(EffectList<Effects...> /*list*/) {
  EffectMask mask = 0;
  ((mask |= EffectMask{1} << Effects<BoardNumbers>::description.id), ...);
  return mask;
}

template <template <class> class... Effects>
constexpr std::size_t count_of(EffectList<Effects...> /*list*/) {
  return sizeof...(Effects);
}

constexpr std::size_t kMostRegressors = most_regressors(Registry{});
constexpr EffectMask kAllEffects = mask_of(Registry{});

namespace detail {
constexpr std::size_t bits_set(EffectMask mask) {
  std::size_t count = 0;
  for (; mask != 0U; mask &= mask - 1U) ++count;
  return count;
}
}  // namespace detail
static_assert(detail::bits_set(kAllEffects) == count_of(Registry{}), "two effects share an id");

}  // namespace fog
