#pragma once

#include <cstddef>

#include "core/effects/aging.hpp"
#include "core/effects/axial_gradient.hpp"
#include "core/effects/bias.hpp"
#include "core/effects/bias_step.hpp"
#include "core/effects/bias_temperature.hpp"
#include "core/effects/effect.hpp"
#include "core/effects/glass_transition.hpp"
#include "core/effects/late_reference.hpp"
#include "core/effects/light_power.hpp"
#include "core/effects/magnetic.hpp"
#include "core/effects/polarization_ripple.hpp"
#include "core/effects/scale_factor.hpp"
#include "core/effects/scale_factor_asymmetry.hpp"
#include "core/effects/scale_factor_nonlinearity.hpp"
#include "core/effects/scale_factor_temperature.hpp"
#include "core/effects/shupe.hpp"
#include "core/effects/temperature_rate.hpp"
#include "core/effects/temperature_rate_product.hpp"
#include "core/effects/thermal_hysteresis.hpp"
#include "core/effects/thermal_lag.hpp"
#include "core/effects/vibration.hpp"
#include "core/effects/warm_up.hpp"
#include "core/signal/quantities.hpp"

// A user's own effects (TUTORIAL.md): the header that CMake's FOG_OWN_EFFECTS names defines
// OwnEffects. CMake writes its name into a header and not into command lines. So only files that
// include this one depend on the list.
#if __has_include("fog_own_effects.hpp")
#include "fog_own_effects.hpp"
#endif
#ifdef FOG_OWN_EFFECTS
#include FOG_OWN_EFFECTS
#else
namespace fog {
using OwnEffects = EffectList<>;
}  // namespace fog
#endif

namespace fog {

/// The effects of this tree. A line here makes an effect known to fit, export, replay and the
/// board.
using Catalogue = EffectList<effects::Bias,                     //
                             effects::BiasTemperature,          //
                             effects::TemperatureRate,          //
                             effects::Shupe,                    //
                             effects::ThermalLag,               //
                             effects::TemperatureRateProduct,   //
                             effects::AxialGradient,            //
                             effects::PolarizationRipple,       //
                             effects::ThermalHysteresis,        //
                             effects::GlassTransition,          //
                             effects::ScaleFactor,              //
                             effects::ScaleFactorTemperature,   //
                             effects::ScaleFactorNonlinearity,  //
                             effects::ScaleFactorAsymmetry,     //
                             effects::WarmUp,                   //
                             effects::Aging,                    //
                             effects::Magnetic,                 //
                             effects::Vibration,                //
                             effects::LightPower,               //
                             effects::LateReference,            //
                             effects::BiasStep>;

template <template <class> class... First, template <class> class... Second>
EffectList<First..., Second...> joined(EffectList<First...> first, EffectList<Second...> second);

/// All effects that are compiled here.
using Registry = decltype(joined(Catalogue{}, OwnEffects{}));

/// Largest number of regressors of any effect.
template <template <class> class... Effects>
constexpr std::size_t max_regressors(EffectList<Effects...> /*list*/) {
  std::size_t max = 0;
  ((max = Effects<BoardNumbers>::coefficients.size() > max
              ? Effects<BoardNumbers>::coefficients.size()
              : max),
   ...);
  return max;
}

constexpr EffectMask bit_of(const EffectDescription& effect) {
  return EffectMask{1} << effect.id;
}

template <template <class> class... Effects>
constexpr EffectMask board_effects(EffectList<Effects...> /*list*/) {
  return ((Effects<BoardNumbers>::description.host_only == nullptr
               ? bit_of(Effects<BoardNumbers>::description)
               : 0U) |
          ...);
}

/// The effects that follow the input rate.
template <template <class> class... Effects>
constexpr EffectMask rate_effects(EffectList<Effects...> /*list*/) {
  return ((follows_input_rate(Effects<BoardNumbers>::description.needs)
               ? bit_of(Effects<BoardNumbers>::description)
               : 0U) |
          ...);
}

/// Inputs that the effects in `mask` need beside the coil temperature.
template <template <class> class... Effects>
constexpr InputMask needs_of(EffectMask mask, EffectList<Effects...> /*list*/) {
  return (((mask & bit_of(Effects<BoardNumbers>::description)) != 0U
               ? Effects<BoardNumbers>::description.needs
               : 0U) |
          ...);
}
constexpr InputMask needs_of(EffectMask mask) {
  return needs_of(mask, Registry{});
}

template <template <class> class... Effects>
constexpr bool ids_differ(EffectList<Effects...> /*list*/) {
  EffectMask seen = 0;
  bool differ = true;
  ((differ = differ && (seen & bit_of(Effects<BoardNumbers>::description)) == 0U,
    seen |= bit_of(Effects<BoardNumbers>::description)),
   ...);
  return differ;
}
static_assert(ids_differ(Registry{}), "two effects share an id");

/// Ids from here to 31 are kept for the effects of users.
constexpr EffectMask kOwnIds = ~EffectMask{0} << 24;

template <template <class> class... Effects>
constexpr EffectMask ids_of(EffectList<Effects...> /*list*/) {
  return (bit_of(Effects<BoardNumbers>::description) | ... | EffectMask{0});
}
static_assert((ids_of(Catalogue{}) & kOwnIds) == 0, "ids from 24 are kept for users");
static_assert((ids_of(OwnEffects{}) & ~kOwnIds) == 0,
              "an effect of one's own has an id from 24 to 31");

constexpr std::size_t kMaxRegressors = max_regressors(Registry{});
/// All effects that a board can run.
constexpr EffectMask kAllEffects = board_effects(Registry{});

}  // namespace fog
