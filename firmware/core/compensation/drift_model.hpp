#pragma once

#include <cstdint>

#include "core/effects/effect_bank.hpp"
#include "core/expression/expression_bank.hpp"
#include "core/fixed_point/fixed.hpp"
#include "core/network/drift_network.hpp"
#include "core/signal/quantities.hpp"
#include "core/signal/status.hpp"
#include "core/thermal/block_bridge.hpp"
#include "core/thermal/thermal_state.hpp"

namespace fog {

/// How long the model may go without what it needs, and how long it takes to settle.
struct DriftPolicy {
  std::uint32_t hold_blocks = 0;      ///< last drift is used for at most this many
  std::uint32_t accurate_blocks = 0;  ///< ... and is as good as the model for this many
  std::uint32_t settle_blocks = 0;  ///< after a (re)start the lags are not yet where they would be
};

/// For so many times as long as a hold lasted its drift is not sure. How far the temperature left
/// the straight line meanwhile is not known: heat that came at half time is off by rate * hold / 4.
/// Whatever the time constant, a lag's share of that in a temperature rate is at most 0.12 * (hold
/// / time since)^2 of it, 1.3 % after three times the hold.
constexpr std::uint32_t kUnsureHolds = 3;

/// What is to be subtracted, and of what it is made where effects follow the input rate.
template <bool kFollowsRate>
struct DriftNow {
  Rate drift{};
  BoardNumbers::RateDrift of_block{};  ///< of all that stands for the block, and half an LSB
  Signals<BoardNumbers> signals{};     ///< of the block
  bool is_new = false;                 ///< the effects that follow the rate have not seen them yet
  Rate of_sample{};                    ///< the drift of the last sample
};
template <>
struct DriftNow<false> {
  Rate drift{};
};

/// The frozen drift model: thermal state, effects, expressions and network, once per block. Its
/// parameters must outlive it.
template <EffectMask kEffects, ExpressionMask kExpressions, NetworkInputMask kNetworkInputs>
class DriftModel {
 public:
  DriftModel(const ThermalParameters<BoardNumbers>& thermal, const EffectsParameters& effects,
             const ExpressionParameters& expressions, const NetworkParameters& network,
             const DriftPolicy& policy)
      : thermal_(thermal),
        limits_(thermal),
        effects_(effects),
        expressions_(expressions, effects.coefficient_fraction),
        network_(network),
        policy_(policy),
        bridge_(policy.hold_blocks),
        course_{policy.settle_blocks} {}

  /// What it can see beside the temperature.
  static constexpr InputMask inputs =
      needs_of(kEffects) | inputs_of_expressions(kExpressions) | inputs_of_network(kNetworkInputs);

  /// Starts from the values of one sample, so that there is a drift before the first block is full.
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
    see_effects(block.input_rate);
  }

  /// What the model was told was wrong: there is no drift until it is started anew.
  void stop() { started_ = false; }

  /// The means of one more block. The model is stepped by catch_up(): once, and once more for each
  /// block before it that was held.
  void take(const BlockMeans<BoardNumbers>& block) {
    if (!started_ || !bridge_.aim(block, course_.since_good)) return start(block);
    course_.since_good = 0;
  }

  /// One step, if one is due; a drift that was held is held until the last.
  void catch_up() {
    if (!started_ || bridge_.left() == 0) return;
    if (course_.settling_blocks > 0) --course_.settling_blocks;
    const auto held = course_.now;
    evaluate(thermal_.step(bridge_.next()));
    if (bridge_.left() > 0) {
      course_.now = held;
    } else {
      settle_after(course_.held_blocks - course_.since_good);
      course_.held_blocks = course_.since_good;
    }
  }

  /// take(), all steps that are due, and the drift at the block's mean rate.
  void step(const BlockMeans<BoardNumbers>& block) {
    take(block);
    while (bridge_.left() > 0) catch_up();  // it has been started
    see_effects(block.input_rate);
  }

  /// So many blocks without a trustworthy temperature or input: the drift stays.
  void hold(std::uint32_t blocks) {
    course_.held_blocks = held_after(course_.held_blocks, blocks);
    course_.since_good = held_after(course_.since_good, blocks);
  }

  /// The rate that is measured now. Effects that follow the input rate see it less the drift of the
  /// sample before, as they see the compensated rate of a block: at 1000 deg/s^2 and 1000 ppm the
  /// 5 ms between two samples make 0.02 deg/h.
  void see(Rate measured) {
    if constexpr (Effects::follows_rate) {
      see_effects(BoardNumbers::saturating_difference(measured, course_.now.of_sample));
      course_.now.of_sample = course_.now.drift;
    }
  }

  /// In place of see() where the measured rate is not valid: the drift of a new block is taken over
  /// at the block's mean rate, so that an image without these effects sends the same.
  void see_none() {
    if constexpr (Effects::follows_rate) {
      if (!course_.now.is_new) return;
      see_effects(course_.now.signals.block.input_rate);
      course_.now.of_sample = course_.now.drift;
    }
  }

  /// What is to be subtracted now.
  Rate drift() const { return course_.now.drift; }

  Status status() const {
    return course_.flags | status_if(course_.held_blocks > 0, Status::drift_held) |
           status_if(course_.held_blocks > policy_.accurate_blocks, Status::drift_outdated) |
           status_if(!started_ || course_.held_blocks > policy_.hold_blocks,
                     Status::drift_given_up) |
           status_if(course_.settling_blocks > 0, Status::thermal_settling);
  }

  bool started() const { return started_; }

  /// Whether it has been stepped with all blocks so far, so that carry() has all of its state.
  bool has_caught_up() const { return bridge_.left() == 0; }
  /// The state of one that has caught up. What is read back belongs to the time when it was
  /// written: the blocks since then are held(), like any that are lost.
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
  /// What was measured in the last good block.
  const BlockMeans<BoardNumbers>& last_block() const { return bridge_.passed(); }

 private:
  using Effects = EffectBank<kEffects>;
  using RateDrift = BoardNumbers::RateDrift;
  struct Course {
    std::uint32_t settling_blocks;  // until it has settled
    std::uint32_t held_blocks = 0;  // since the drift was that of its block; to hold_blocks + 1
    std::uint32_t since_good = 0;   // of these, those after the last good block
    Status flags = Status::none;    // of the last step
    DriftNow<Effects::follows_rate> now{};
  };
  static constexpr int kRateBits = RateDrift::fractional_bits - Rate::fractional_bits;

  // Up to one more than may be held.
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

  void evaluate(const Signals<BoardNumbers>& signals) {
    const Temperature temperature = signals.block.temperature;
    const DriftSum drift =
        effects_.step(signals) + expressions_.step(signals) + network_.step(signals);
    if constexpr (Effects::follows_rate) {
      const auto held =
          clamp(drift, round_to<DriftSum>(Rate::lowest()), round_to<DriftSum>(Rate::highest()));
      course_.now.of_block =
          round_to<RateDrift>(held) + RateDrift::from_raw(rounding_half<RateDrift::Raw>(kRateBits));
      course_.now.signals = signals;
      course_.now.is_new = true;
    } else {
      course_.now.drift = saturate_to<Rate>(drift);
    }
    course_.flags = status_if(temperature < limits_.min || temperature > limits_.max,
                              Status::temperature_clamped) |
                    status_if(!effects_.history_known() || !expressions_.history_known(),
                              Status::history_unknown);
  }

  // The sum fits: held_within().
  void see_effects(Rate rate) {
    if constexpr (Effects::follows_rate) {
      if (course_.now.is_new) set_effects();
      const RateDrift sum = effects_.at(rate, course_.now.of_block);
      course_.now.drift = Rate::from_raw(saturating_shift<kRateBits>(sum.raw()));
    }
  }

  // What they make of the block is worked out with the sample after it, which has less to do than
  // the one that ends a block.
  [[gnu::noinline]] void set_effects() {
    effects_.set(course_.now.signals);
    course_.now.is_new = false;
  }

  ThermalState<BoardNumbers> thermal_;
  const ThermalParameters<BoardNumbers>& limits_;
  Effects effects_;
  ExpressionBank<kExpressions> expressions_;
  DriftNetwork<kNetworkInputs> network_;
  const DriftPolicy& policy_;
  BlockBridge<BoardNumbers, inputs> bridge_;

  bool started_ = false;
  Course course_;
};

}  // namespace fog
