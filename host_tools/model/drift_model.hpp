#pragma once

#include <memory>
#include <vector>

#include "core/signal/quantities.hpp"
#include "core/thermal/thermal_state.hpp"
#include "model/catalogue.hpp"
#include "model/model.hpp"

namespace fogcomp::model {

/// Inputs of a model for one block.
using RealBlock = fog::BlockMeans<RealNumbers>;

/// The same values in double, exact.
RealBlock to_real(const fog::BlockMeans<fog::BoardNumbers>& block);

/// Parameters of the thermal stage for a block period; the board's table has them rounded.
fog::ThermalParameters<RealNumbers> thermal_parameters(const Model& model, double block_s);

/// Whether a term is an effect that follows the input rate (fog::follows_input_rate).
bool follows_input_rate(const EffectTerm& term);

/// Regressors of a set of effects from block means: the board's own code in double. `terms` needs
/// only names and parameters.
class RegressorBank {
 public:
  RegressorBank(const std::vector<EffectTerm>& terms, double block_s);

  std::size_t size() const { return values_.size(); }
  void reset(const fog::Signals<RealNumbers>& signals);
  /// Advances by one block; the result is valid until the next call.
  const std::vector<double>& step(const fog::Signals<RealNumbers>& signals);
  /// Only the effects that follow the input rate.
  const std::vector<double>& see_rate(const fog::Signals<RealNumbers>& signals);

 private:
  struct Part {
    std::unique_ptr<RealEffect> effect;
    bool follows_rate;
  };
  template <class Wanted>
  const std::vector<double>& run(const fog::Signals<RealNumbers>& signals, Wanted wanted);

  std::vector<Part> parts_;
  std::vector<double> values_;
};

/// fog::DriftModel in double: reference for the board's rounding, and the model of fit and compare.
class RealDriftModel {
 public:
  RealDriftModel(const Model& model, double block_s);

  /// Starts from one sample, with temperature rate 0.
  void start(const RealBlock& block);
  /// What went before, of which some is kept over a gap.
  void forget();
  /// Takes the means of one more block.
  void step(const RealBlock& block);
  /// Takes the input rate of the present block, for the effects that follow it.
  void see_rate(const RealBlock& block);

  double drift_dph() const { return physics_dph_ + network_dph_; }
  double network_dph() const { return network_dph_; }
  /// Drift of one effect, by its position in the model.
  double effect_dph(std::size_t term) const { return effects_dph_[term]; }
  const fog::Signals<RealNumbers>& signals() const { return signals_; }

 private:
  void evaluate();
  void sum(const std::vector<double>& regressors);

  const Model& model_;
  double block_s_;
  fog::ThermalState<RealNumbers> thermal_;
  RegressorBank bank_;
  NetworkSignals network_signals_;
  fog::Signals<RealNumbers> signals_;
  std::vector<double> effects_dph_;
  double physics_dph_ = 0;
  double network_dph_ = 0;
};

}  // namespace fogcomp::model
