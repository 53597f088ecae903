#pragma once

#include <cstdint>

#include "core/compensation/drift_policy.hpp"
#include "core/effects/effect_bank.hpp"
#include "core/expression/expression_bank.hpp"
#include "core/fixed_point/fixed.hpp"
#include "core/network/drift_network.hpp"
#include "core/signal/quantities.hpp"
#include "core/signal/status.hpp"
#include "core/thermal/block_bridge.hpp"
#include "core/thermal/thermal_state.hpp"

namespace fog {

/// After a hold, the drift counts as unsure for kUnsureHolds times the length of the hold. The
/// temperature may have left the assumed straight line: heating that began at half time gives an
/// error of rate * hold / 4. Through a first-order lag of any time constant, at most 0.12 * (hold /
/// time since)^2 of it remains in a temperature rate: 1.3 % after three times the hold.
constexpr std::uint32_t kUnsureHolds = 3;

/// The block's part of a drift has so many bits more than a Rate. Clipped to Rate, with half an
/// LSB, it leaves the rest of 64 bits to the effects of the input rate (tests/proof).
constexpr int kBlockDriftBits = BoardNumbers::RateDrift::fractional_bits - Rate::fractional_bits;
static_assert(kBlockDriftBits < 32);
constexpr std::int64_t kMaxBlockDrift =
    shift_left(-std::int64_t{Rate::lowest().raw()}, kBlockDriftBits) +
    rounding_half<std::int64_t>(kBlockDriftBits);

/// The drift to be subtracted, and its two parts if there are effects of the input rate.
template <bool kFollowsRate>
struct DriftNow {
  Rate drift{};
  BoardNumbers::RateDrift of_block{};  ///< drift of the block part, plus half an LSB
  Signals<BoardNumbers> signals{};     ///< of the block
  bool is_new = false;                 ///< not yet passed to the effects that follow the rate
  Rate of_sample{};                    ///< drift of the last sample, from these effects
};
template <>
struct DriftNow<false> {
  Rate drift{};
};

/// The frozen drift model, run once per block: thermal state, effects, expressions and network. Its
/// parameters must outlive it.
template <EffectMask kEffects, ExpressionMask kExpressions, NetworkInputMask kNetworkInputs>
class DriftModel {
 public:
  DriftModel(const ThermalParameters<BoardNumbers>& thermal, const EffectsParameters& effects,
             const ExpressionParameters& expressions, const NetworkParameters& network,
             const DriftPolicy& policy)
      : thermal_(thermal),
        effects_(effects),
        expressions_(expressions, effects.coefficient_fraction),
        network_(network),
        policy_(policy),
        bridge_(policy.hold_blocks),
        course_{policy.settle_blocks} {}

  /// Inputs that it can use beside the temperature.
  static constexpr InputMask inputs =
      needs_of(kEffects) | inputs_of_expressions(kExpressions) | inputs_of_network(kNetworkInputs);

  /// Starts from one sample, so that there is a drift before the first block is complete.
  void start(const BlockMeans<BoardNumbers>& block) {
    const Signals<BoardNumbers> signals = thermal_.reset(block);
    effects_.reset(signals);
    expressions_.reset(signals);
    network_.reset(signals);
    bridge_.start(block);
    started_ = true;
    course_.settling_blocks = policy_.settle_blocks;
    course_.held_blocks = course_.since_good = 0;
    evaluate(signals);
    update_rate_effects(block.input_rate);
  }

  /// Discards a state that was built on wrong inputs: no drift until the next start().
  void stop() { started_ = false; }

  /// Takes the means of one more block. catch_up() steps the model: once for this block and once
  /// for each block held before it. A block that comes before all are stepped counts as held: the
  /// drift does not follow it yet, and its means become part of the bridge.
  void take(const BlockMeans<BoardNumbers>& block) {
    if (bridge_.remaining() > 0) course_.held_blocks = held_after(course_.held_blocks, 1);
    if (!started_ || course_.held_blocks > policy_.hold_blocks ||
        !bridge_.bridge_to(block, course_.since_good)) {
      return start(block);
    }
    course_.since_good = 0;
  }

  /// Makes one step, if one is due. A held drift stays until the last step.
  void catch_up() {
    if (!started_ || bridge_.remaining() == 0) return;
    if (course_.settling_blocks > 0) --course_.settling_blocks;
    const auto held = course_.now;
    const Signals<BoardNumbers> signals = thermal_.step(bridge_.next());
    const bool is_last = bridge_.remaining() == 0;
    const std::uint32_t bridged = course_.held_blocks - course_.since_good;
    evaluate(signals, is_last && bridged > policy_.accurate_blocks);
    if (!is_last) {
      course_.now = held;
    } else {
      settle_after(bridged);
      course_.held_blocks = course_.since_good;
    }
  }

  /// take(), all due steps, and the drift at the block's mean rate.
  void step(const BlockMeans<BoardNumbers>& block) {
    take(block);
    while (bridge_.remaining() > 0) catch_up();  // take() has started it
    update_rate_effects(block.input_rate);
  }

  /// The model may have been stepped too often or too rarely: it has to settle, once it has been
  /// stepped for the blocks before.
  void unsettle() {
    // Wraps only with a hold of years.
    course_.settling_blocks = policy_.settle_blocks + bridge_.remaining() + course_.since_good;
  }

  /// `blocks` blocks without a valid temperature or input: the drift stays.
  void hold(std::uint32_t blocks) {
    course_.held_blocks = held_after(course_.held_blocks, blocks);
    course_.since_good = held_after(course_.since_good, blocks);
  }

  /// Takes the measured rate. Effects of the input rate use it less the drift of the previous
  /// sample; for a block they use the compensated rate. At 1000 deg/s^2 and 1000 ppm the delay of 5
  /// ms makes 0.02 deg/h. If the rate is not valid, a new block's drift is taken over at the
  /// block's mean rate, so that an image without these effects sends the same bytes.
  void update_rate(Rate measured, bool valid) {
    if constexpr (Effects::follows_rate) {
      if (!valid && !course_.now.is_new) return;
      update_rate_effects(valid
                              ? BoardNumbers::saturating_difference(measured, course_.now.of_sample)
                              : course_.now.signals.block.input_rate);
      course_.now.of_sample = course_.now.drift;
    }
  }

  /// Drift to be subtracted now.
  Rate drift() const { return course_.now.drift; }

  Status status() const {
    return course_.flags | status_if(course_.held_blocks > 0, Status::drift_held) |
           status_if(course_.held_blocks > policy_.accurate_blocks, Status::drift_outdated) |
           status_if(!started_ || course_.held_blocks > policy_.hold_blocks,
                     Status::drift_given_up) |
           status_if(course_.settling_blocks > 0, Status::thermal_settling);
  }

  bool started() const { return started_; }

  /// Whether all blocks taken so far have been stepped, so that carry() saves the whole state.
  bool has_caught_up() const { return bridge_.remaining() == 0; }
  /// State of a model that has caught up. The blocks since the state was written are to be passed
  /// to hold(), like other lost blocks.
  void carry(StateCarrier& state) {
    thermal_.carry(state);
    effects_.carry(state);
    expressions_.carry(state);
    network_.carry(state);
    bridge_.carry(state);
    state(course_);
    started_ = true;
    if constexpr (Effects::follows_rate)
      course_.now.is_new = course_.now.is_new || state.restores();
  }
  /// Means of the last good block.
  const BlockMeans<BoardNumbers>& last_block() const { return bridge_.last_stepped(); }

 private:
  using Effects = EffectBank<kEffects>;
  using RateDrift = BoardNumbers::RateDrift;
  struct Course {
    std::uint32_t settling_blocks;     // left until it has settled
    std::uint32_t held_blocks = 0;     // since the drift was computed; at most hold_blocks + 1
    std::uint32_t since_good = 0;      // of these, the ones after the last good block
    std::uint32_t clamped_blocks = 0;  // left until lags have forgotten a clamped input
    Status flags = Status::none;       // of the last step
    DriftNow<Effects::follows_rate> now{};
  };

  // At most hold_blocks + 1.
  std::uint32_t held_after(std::uint32_t held, std::uint32_t blocks) const {
    const std::uint32_t given_up = policy_.hold_blocks + 1;
    return blocks < given_up - held ? held + blocks : given_up;
  }

  void settle_after(std::uint32_t bridged_blocks) {
    const std::uint32_t all = policy_.settle_blocks;
    const std::uint32_t unsure =
        bridged_blocks < all / kUnsureHolds ? kUnsureHolds * bridged_blocks : all;
    if (bridged_blocks > 0 && course_.settling_blocks < unsure) course_.settling_blocks = unsure;
  }

  // `way_unknown`: the temperature may have turned on its way to this block, and a play with it.
  void evaluate(const Signals<BoardNumbers>& signals, bool way_unknown = false) {
    const bool is_outside = outside(signals);
    if (is_outside || way_unknown) {
      effects_.forget_history();
      expressions_.forget_history();
    }
    const DriftSum drift =
        effects_.step(signals) + expressions_.step(signals) + network_.step(signals);
    if constexpr (Effects::follows_rate) {
      const auto held =
          clamp(drift, round_to<DriftSum>(Rate::lowest()), round_to<DriftSum>(Rate::highest()));
      course_.now.of_block = round_to<RateDrift>(held) +
                             RateDrift::from_raw(rounding_half<RateDrift::Raw>(kBlockDriftBits));
      course_.now.signals = signals;
      course_.now.is_new = true;
    } else {
      course_.now.drift = saturate_to<Rate>(drift);
    }
    if (is_outside || expressions_.clamped() || network_.clamped()) {
      course_.clamped_blocks = policy_.settle_blocks + 1;
    } else if (course_.clamped_blocks > 0) {
      --course_.clamped_blocks;
    }
    course_.flags = status_if(course_.clamped_blocks > 0, Status::temperature_clamped) |
                    status_if(!effects_.history_known() || !expressions_.history_known(),
                              Status::history_unknown);
  }

  // Whether the model sees another temperature, or temperature rate, than there was.
  bool outside(const Signals<BoardNumbers>& signals) const {
    constexpr auto kMaxRate = from_integer<TemperatureRate>(kMaxRateDegcPerMin);
    const TemperatureRate rate = signals.temperature_rate;
    return signals.temperature != signals.block.temperature || rate == kMaxRate ||
           rate == -kMaxRate;
  }

  // The sum fits (held_within()).
  void update_rate_effects(Rate rate) {
    if constexpr (Effects::follows_rate) {
      if (course_.now.is_new) update_block_effects();
      const RateDrift sum = effects_.at(rate, course_.now.of_block);
      course_.now.drift = Rate::from_raw(saturating_shift<kBlockDriftBits>(sum.raw()));
    }
  }

  // Evaluated with the sample after the block, which has less to do than the one that ends it.
  [[gnu::noinline]] void update_block_effects() {
    effects_.set(course_.now.signals);
    course_.now.is_new = false;
  }

  ThermalState<BoardNumbers> thermal_;
  Effects effects_;
  ExpressionBank<kExpressions> expressions_;
  DriftNetwork<kNetworkInputs> network_;
  const DriftPolicy& policy_;
  BlockBridge<BoardNumbers, inputs> bridge_;

  bool started_ = false;
  Course course_;
};

}  // namespace fog
