#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#include "core/bytes/state_carrier.hpp"
#include "core/effects/effect.hpp"
#include "core/effects/effect_parameters.hpp"
#include "core/effects/registry.hpp"
#include "core/fixed_point/fixed.hpp"
#include "core/signal/quantities.hpp"
#include "core/signal/span.hpp"
#include "core/signal/weighted_sum.hpp"

namespace fog {

namespace detail {

template <class Effect, class = void>
struct HasHistory : std::false_type {};
template <class Effect>
struct HasHistory<Effect, std::void_t<decltype(std::declval<const Effect&>().history_known())>>
    : std::true_type {};

template <class Effect, class = void>
struct HasState : std::false_type {};
template <class Effect>
struct HasState<Effect,
                std::void_t<decltype(std::declval<Effect&>().carry(std::declval<StateCarrier&>()))>>
    : std::true_type {};

}  // namespace detail

/// Largest product in a weighted_sum(), of any words of the table and any regressors.
constexpr std::int64_t kMaxWeightedProduct = power_of_two<std::int64_t>(
    62 - (kMinCoefficientFraction + Regressor::fractional_bits - DriftSum::fractional_bits));
// All effects, and a network and the expressions beside them, sum up within 64 bits.
static_assert(kMaxWeightedProduct <=
              INT64_MAX / static_cast<std::int64_t>((kMaxEffects + 2) * kMaxRegressors));
static_assert(kMaxCoefficientFraction + Regressor::fractional_bits - DriftSum::fractional_bits <=
              62);  // rounded_product()'s
// EffectBank::set(): any word in the format of a Coefficient.
static_assert(31 + BoardNumbers::Coefficient::fractional_bits - kMinCoefficientFraction <= 63);

/// The effects of a model and their sum. Only effects in kCompiled exist in the image; read_model
/// refuses a table that enables another one.
template <EffectMask kCompiled>
class EffectBank {
 public:
  using BoardSignals = Signals<BoardNumbers>;
  using RateDrift = BoardNumbers::RateDrift;

  explicit EffectBank(const EffectsParameters& parameters) : EffectBank(parameters, Registry{}) {}

  /// Starts all states from `signals`.
  void reset(const BoardSignals& signals) {
    for_each([&](auto& slot) {
      if constexpr (!follows<decltype(slot.effect)>) slot.effect.reset(signals);
    });
  }

  /// Whether an effect of the image follows the input rate.
  static constexpr bool follows_rate = (kCompiled & rate_effects(Registry{})) != 0;

  /// Advances all states by one block and returns the drift of the effects that depend on block
  /// means. With expressions and network: 32 sums, each below 2^48.
  DriftSum step(const BoardSignals& signals) {
    DriftSum drift{};
    for_each([&](auto& slot) {
      if constexpr (!follows<decltype(slot.effect)>) {
        std::array<Regressor, std::decay_t<decltype(slot.effect)>::coefficients.size()> regressors;
        slot.effect.step(signals, regressors.data());
        drift += weighted_sum(slot.coefficients, regressors.data(), coefficient_fraction_);
      }
    });
    return drift;
  }

  /// Evaluates the block part of the effects that follow the input rate.
  void set(const BoardSignals& signals) {
    for_each([&](auto& slot) {
      if constexpr (follows<decltype(slot.effect)>) {
        using Coefficient = BoardNumbers::Coefficient;
        std::array<Coefficient, std::decay_t<decltype(slot.effect)>::coefficients.size()> exact{};
        for (std::size_t i = 0; i < slot.coefficients.size; ++i) {
          const std::int64_t raw = slot.coefficients.data[i];
          exact[i] = Coefficient::from_raw(
              shift_left(raw, Coefficient::fractional_bits - coefficient_fraction_));
        }
        slot.effect.set(signals, exact.data());
      }
    });
  }
  /// Adds their drift at `rate` to `drift`; a disabled effect adds 0.
  RateDrift at(Rate rate, RateDrift drift) const {
    std::apply([&](const auto&... slots) { (add_at(slots, rate, drift), ...); }, slots_);
    return drift;
  }

  void carry(StateCarrier& state) {
    for_each([&](auto& slot) {
      if constexpr (detail::HasState<std::decay_t<decltype(slot.effect)>>::value) {
        slot.effect.carry(state);
      }
    });
  }

  /// Whether no state depends any more on what happened before the start.
  bool history_known() {
    bool known = true;
    for_each([&](auto& slot) {
      if constexpr (detail::HasHistory<std::decay_t<decltype(slot.effect)>>::value) {
        known = known && slot.effect.history_known();
      }
    });
    return known;
  }

  /// To be called before a step whose temperature may have come another way than it seems.
  void forget_history() {
    for_each([](auto& slot) {
      if constexpr (detail::HasHistory<std::decay_t<decltype(slot.effect)>>::value) {
        slot.effect.forget_history();
      }
    });
  }

 private:
  template <class Effect>
  static constexpr bool follows = follows_input_rate(Effect::description.needs);

  template <class Effect>
  struct Slot {
    explicit Slot(const EffectParameters& parameters)
        : effect(parameters.constants), coefficients(parameters.coefficients) {}
    Effect effect;
    Span<const std::int32_t> coefficients;
  };
  // An effect that this image does not have: no state, no code.
  template <class Effect>
  struct NoSlot {
    explicit NoSlot(const EffectParameters& /*parameters*/) {}
  };
  template <class Effect>
  using SlotFor = std::conditional_t<((kCompiled >> Effect::description.id) & 1U) != 0U,
                                     Slot<Effect>, NoSlot<Effect>>;

  template <class List>
  struct SlotsOf;
  template <template <class> class... Effects>
  struct SlotsOf<EffectList<Effects...>> {
    using Type = std::tuple<SlotFor<Effects<BoardNumbers>>...>;
  };

  template <template <class> class... Effects>
  EffectBank(const EffectsParameters& parameters, EffectList<Effects...> /*list*/)
      : coefficient_fraction_(parameters.coefficient_fraction),
        slots_(parameters.by_id[Effects<BoardNumbers>::description.id]...) {}

  template <class Function>
  void for_each(Function function) {
    std::apply([&](auto&... slots) { (visit(slots, function), ...); }, slots_);
  }
  template <class Effect, class Function>
  static void visit(Slot<Effect>& slot, Function& function) {
    if (slot.coefficients.size != 0) function(slot);
  }
  template <class Effect, class Function>
  static void visit(NoSlot<Effect>& /*slot*/, Function& /*function*/) {}

  // Always inlined, even long effects: a call per sample would cost a tenth of the time.
  template <class Effect>
  [[gnu::always_inline]] static void add_at(const Slot<Effect>& slot, Rate rate, RateDrift& drift) {
    if constexpr (follows<Effect>) drift += slot.effect.at(rate);
  }
  template <class Effect>
  static void add_at(const NoSlot<Effect>& /*slot*/, Rate /*rate*/, RateDrift& /*drift*/) {}

  int coefficient_fraction_;
  typename SlotsOf<Registry>::Type slots_;
};

}  // namespace fog
