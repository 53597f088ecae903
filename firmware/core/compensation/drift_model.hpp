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
        settling_blocks_(policy.settle_blocks) {}

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
    settling_blocks_ = policy_.settle_blocks;
    held_blocks_ = since_good_ = 0;
    evaluate(signals);
    see_effects(block.input_rate);
  }

  /// What the model was told was wrong: there is no drift until it is started anew.
  void stop() { started_ = false; }

  /// The means of one more block. The model is stepped by catch_up(): once, and once more for each
  /// block before it that was held.
  void take(const BlockMeans<BoardNumbers>& block) {
    if (!started_ || !bridge_.aim(block, since_good_)) return start(block);
    since_good_ = 0;
  }

  /// One step, if one is due; a drift that was held is held until the last.
  void catch_up() {
    if (!started_ || bridge_.left() == 0) return;
    if (settling_blocks_ > 0) --settling_blocks_;
    const auto held = now_;
    evaluate(thermal_.step(bridge_.next()));
    if (bridge_.left() > 0) {
      now_ = held;
    } else {
      settle_after(held_blocks_ - since_good_);
      held_blocks_ = since_good_;
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
    held_blocks_ = held_after(held_blocks_, blocks);
    since_good_ = held_after(since_good_, blocks);
  }

  /// The rate that is measured now. Effects that follow the input rate see it less the drift of the
  /// sample before, as they see the compensated rate of a block: at 1000 deg/s^2 and 1000 ppm the
  /// 5 ms between two samples make 0.02 deg/h.
  void see(Rate measured) {
    if constexpr (Effects::follows_rate) {
      see_effects(BoardNumbers::saturating_difference(measured, now_.of_sample));
      now_.of_sample = now_.drift;
    }
  }

  /// What is to be subtracted now.
  Rate drift() const { return now_.drift; }

  Status status() const {
    return flags_ | status_if(held_blocks_ > 0, Status::drift_held) |
           status_if(held_blocks_ > policy_.accurate_blocks, Status::drift_outdated) |
           status_if(!started_ || held_blocks_ > policy_.hold_blocks, Status::drift_given_up) |
           status_if(settling_blocks_ > 0, Status::thermal_settling);
  }

  bool started() const { return started_; }

 private:
  using Effects = EffectBank<kEffects>;
  using RateDrift = BoardNumbers::RateDrift;
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
    if (bridged_blocks > 0 && settling_blocks_ < unsure) settling_blocks_ = unsure;
  }

  void evaluate(const Signals<BoardNumbers>& signals) {
    const Temperature temperature = signals.block.temperature;
    const DriftSum drift =
        effects_.step(signals) + expressions_.step(signals) + network_.step(signals);
    if constexpr (Effects::follows_rate) {
      const auto held =
          clamp(drift, round_to<DriftSum>(Rate::lowest()), round_to<DriftSum>(Rate::highest()));
      now_.of_block =
          round_to<RateDrift>(held) + RateDrift::from_raw(rounding_half<RateDrift::Raw>(kRateBits));
      now_.signals = signals;
      now_.is_new = true;
    } else {
      now_.drift = saturate_to<Rate>(drift);
    }
    flags_ = status_if(temperature < limits_.least || temperature > limits_.most,
                       Status::temperature_clamped) |
             status_if(!effects_.history_known() || !expressions_.history_known(),
                       Status::history_unknown);
  }

  // The sum fits: held_within().
  void see_effects(Rate rate) {
    if constexpr (Effects::follows_rate) {
      if (now_.is_new) set_effects();
      const RateDrift sum = effects_.at(rate, now_.of_block);
      now_.drift = Rate::from_raw(saturating_shift<kRateBits>(sum.raw()));
    }
  }

  // What they make of the block is worked out with the sample after it, which has less to do than
  // the one that ends a block.
  [[gnu::noinline]] void set_effects() {
    effects_.set(now_.signals);
    now_.is_new = false;
  }

  ThermalState<BoardNumbers> thermal_;
  const ThermalParameters<BoardNumbers>& limits_;
  Effects effects_;
  ExpressionBank<kExpressions> expressions_;
  DriftNetwork<kNetworkInputs> network_;
  const DriftPolicy& policy_;
  BlockBridge<BoardNumbers, inputs> bridge_;

  bool started_ = false;
  std::uint32_t held_blocks_ = 0;  // since the drift was that of its block; to hold_blocks + 1
  std::uint32_t since_good_ = 0;   // of these, those after the last good block
  std::uint32_t settling_blocks_;  // until it has settled
  Status flags_ = Status::none;    // of the last step
  DriftNow<Effects::follows_rate> now_;
};

}  // namespace fog
