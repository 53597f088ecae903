#pragma once

#include <memory>
#include <vector>

#include "core/signal/quantities.hpp"
#include "core/thermal/thermal_state.hpp"
#include "model/catalogue.hpp"
#include "model/model.hpp"

namespace fogcomp::model {

/// What a model sees of one block.
using RealBlock = fog::BlockMeans<RealNumbers>;

/// The same values, exactly.
RealBlock to_real(const fog::BlockMeans<fog::BoardNumbers>& block);

/// Numbers of the thermal stage for a block period. The board's table is the rounding of these.
fog::ThermalParameters<RealNumbers> thermal_parameters(const Model& model, double block_s);

/// Whether a term is an effect that follows the input rate (fog::follows_input_rate).
bool follows_input_rate(const EffectTerm& term);

/// Regressors of a set of effects over block means: the board's own code in double. `terms` needs
/// names and parameters only.
class RegressorBank {
 public:
  RegressorBank(const std::vector<EffectTerm>& terms, double block_s);

  std::size_t size() const { return values_.size(); }
  void reset(const fog::Signals<RealNumbers>& signals);
  /// Advances one block; the result is valid until the next call.
  const std::vector<double>& step(const fog::Signals<RealNumbers>& signals);
  /// The same but for the effects that see the record of the input rate (host only, with a state):
  /// they are advanced by see_rate() alone. Values of effects that are left out stay.
  const std::vector<double>& step_block(const fog::Signals<RealNumbers>& signals);
  /// Of the effects that follow the input rate alone.
  const std::vector<double>& see_rate(const fog::Signals<RealNumbers>& signals);

 private:
  struct Part {
    std::unique_ptr<RealEffect> effect;
    bool follows_rate;
    bool host_only;
  };
  template <class Wanted>
  const std::vector<double>& run(const fog::Signals<RealNumbers>& signals, Wanted wanted);

  std::vector<Part> parts_;
  std::vector<double> values_;
};

/// fog::DriftModel in double: the reference for the board's rounding, and the model that fit and
/// compare see.
class RealDriftModel {
 public:
  RealDriftModel(const Model& model, double block_s);

  /// From the values of one sample, temperature rate 0.
  void start(const RealBlock& block);
  /// The means of one more block.
  void step(const RealBlock& block);
  /// The mean input rate of the block that now runs, for the effects that follow it.
  void see_rate(double input_rate_dph);

  double drift_dph() const { return physics_dph_ + network_dph_; }
  double network_dph() const { return network_dph_; }
  /// Part of one effect, by its place in the model.
  double effect_dph(std::size_t term) const { return effects_dph_[term]; }
  const fog::Signals<RealNumbers>& signals() const { return signals_; }

 private:
  void evaluate();
  void sum(const std::vector<double>& regressors);

  const Model& model_;
  fog::ThermalState<RealNumbers> thermal_;
  RegressorBank bank_;
  NetworkSignals network_signals_;
  fog::Signals<RealNumbers> signals_;
  std::vector<double> effects_dph_;
  double physics_dph_ = 0;
  double network_dph_ = 0;
};

}  // namespace fogcomp::model
