#pragma once

#include <cstdint>

#include "core/effects/effect_bank.hpp"
#include "core/expression/expression_bank.hpp"
#include "core/fixed_point/fixed.hpp"
#include "core/network/drift_network.hpp"
#include "core/signal/quantities.hpp"
#include "core/signal/status.hpp"
#include "core/thermal/thermal_state.hpp"

namespace fog {

/// How long the model may go without what it needs, and how long it takes to settle.
struct DriftPolicy {
  std::uint32_t hold_blocks = 0;    ///< last drift is used for at most this many
  std::uint32_t settle_blocks = 0;  ///< after (re)start the temperature rate is not yet known
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
        policy_(policy) {}

  /// Starts from the values of one sample, so that there is a drift before the first block is full.
  void start(const BlockMeans<BoardNumbers>& block) {
    const Signals<BoardNumbers> signals = thermal_.reset(block);
    effects_.reset(signals);
    expressions_.reset(signals);
    network_.reset(signals);
    started_ = true;
    settled_blocks_ = 0;
    evaluate(signals);
  }

  /// The means of one more block.
  void step(const BlockMeans<BoardNumbers>& block) {
    if (!started_ || held_blocks_ > policy_.hold_blocks) return start(block);
    if (settled_blocks_ < policy_.settle_blocks) ++settled_blocks_;
    evaluate(thermal_.step(block));
  }

  /// So many blocks without a trustworthy temperature or input: the drift stays.
  void hold(std::uint32_t blocks) {
    const std::uint32_t given_up = policy_.hold_blocks + 1;
    held_blocks_ = blocks < given_up - held_blocks_ ? held_blocks_ + blocks : given_up;
  }

  /// What is to be subtracted now.
  Rate drift() const { return drift_; }

  Status status() const {
    return clamped_ | status_if(held_blocks_ > 0, Status::drift_held) |
           status_if(!started_ || held_blocks_ > policy_.hold_blocks, Status::drift_given_up) |
           status_if(settled_blocks_ < policy_.settle_blocks, Status::thermal_settling);
  }

  bool started() const { return started_; }

 private:
  void evaluate(const Signals<BoardNumbers>& signals) {
    const Temperature temperature = signals.block.temperature;
    held_blocks_ = 0;
    clamped_ = status_if(temperature < limits_.least || temperature > limits_.most,
                         Status::temperature_clamped);
    drift_ = saturate_to<Rate>(effects_.step(signals) + expressions_.step(signals) +
                               network_.step(signals));
  }

  ThermalState<BoardNumbers> thermal_;
  const ThermalParameters<BoardNumbers>& limits_;
  EffectBank<kEffects> effects_;
  ExpressionBank<kExpressions> expressions_;
  DriftNetwork<kNetworkInputs> network_;
  const DriftPolicy& policy_;

  bool started_ = false;
  std::uint32_t held_blocks_ = 0;     // counts up to hold_blocks + 1
  std::uint32_t settled_blocks_ = 0;  // counts up to settle_blocks
  Status clamped_ = Status::none;
  Rate drift_{};
};

}  // namespace fog
