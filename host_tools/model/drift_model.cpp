#include "model/drift_model.hpp"

#include <algorithm>
#include <cmath>

namespace fogcomp::model {
namespace {

// Limit of the board's format, so that fit and board clip alike.
const double kMaxRegressor = std::ldexp(1, 31 - fog::Regressor::fractional_bits);

// The rounded limit that the board clamps to: half an LSB, with a scale factor of 300 ppm/degC at
// 280 deg/s, makes 0.002 deg/h.
double rounded_for_board(double degc) {
  return std::ldexp(std::round(std::ldexp(degc, fog::Temperature::fractional_bits)),
                    -fog::Temperature::fractional_bits);
}

}  // namespace

RealBlock to_real(const fog::BlockMeans<fog::BoardNumbers>& block) {
  const auto real = [](auto value) {
    return std::ldexp(value.raw(), -decltype(value)::fractional_bits);
  };
  RealBlock result;
  result.temperature = real(block.temperature);
  result.input_rate = real(block.input_rate);
  result.elapsed = real(block.elapsed);
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
    result.extension[i] = real(block.extension[i]);
  }
  return result;
}

fog::ThermalParameters<RealNumbers> thermal_parameters(const Model& model, double block_s) {
  const double decay = RealNumbers::decay(block_s / model.derivative_tau_s);
  return {{decay, decay * 60 / block_s},
          rounded_for_board(model.min_degc),
          rounded_for_board(model.max_degc)};
}

bool follows_input_rate(const EffectTerm& term) {
  return !term.expression && fog::follows_input_rate(find_effect(term.name).description.needs);
}

RegressorBank::RegressorBank(const std::vector<EffectTerm>& terms, double block_s) {
  std::size_t size = 0;
  for (const EffectTerm& term : terms) {
    parts_.push_back({make_effect(term, block_s), follows_input_rate(term)});
    size += parts_.back().effect->regressor_count();
  }
  values_.resize(size);
}

void RegressorBank::reset(const fog::Signals<RealNumbers>& signals) {
  for (const Part& part : parts_) part.effect->reset(signals);
}

template <class Wanted>
const std::vector<double>& RegressorBank::run(const fog::Signals<RealNumbers>& signals,
                                              Wanted wanted) {
  double* values = values_.data();
  for (const Part& part : parts_) {
    const std::size_t count = part.effect->regressor_count();
    if (wanted(part)) {
      part.effect->step(signals, values);
      // The board has no regressors for effects that follow the rate.
      if (!part.follows_rate) {
        for (std::size_t i = 0; i < count; ++i) {
          values[i] = std::clamp(values[i], -kMaxRegressor, kMaxRegressor);
        }
      }
    }
    values += count;
  }
  return values_;
}

const std::vector<double>& RegressorBank::step(const fog::Signals<RealNumbers>& signals) {
  return run(signals, [](const Part&) { return true; });
}

const std::vector<double>& RegressorBank::see_rate(const fog::Signals<RealNumbers>& signals) {
  return run(signals, [](const Part& part) { return part.follows_rate; });
}

RealDriftModel::RealDriftModel(const Model& model, double block_s)
    : model_(model),
      block_s_(block_s),
      thermal_(thermal_parameters(model, block_s)),
      bank_(model.terms, block_s),
      network_signals_(model.network.inputs, block_s),
      effects_dph_(model.terms.size()) {}

void RealDriftModel::start(const RealBlock& block) {
  signals_ = thermal_.reset(block);
  bank_.reset(signals_);
  network_signals_.reset(signals_);
  evaluate();
}

void RealDriftModel::forget() {
  bank_ = RegressorBank(model_.terms, block_s_);
}

void RealDriftModel::step(const RealBlock& block) {
  signals_ = thermal_.step(block);
  evaluate();
}

void RealDriftModel::see_rate(const RealBlock& block) {
  signals_.block.input_rate = block.input_rate;
  signals_.block.rate_within = block.rate_within;
  sum(bank_.see_rate(signals_));
}

void RealDriftModel::evaluate() {
  sum(bank_.step(signals_));
  network_dph_ = model_.network.drift_dph(network_signals_.step(signals_));
}

void RealDriftModel::sum(const std::vector<double>& regressors) {
  std::size_t column = 0;
  physics_dph_ = 0;
  for (std::size_t i = 0; i < model_.terms.size(); ++i) {
    effects_dph_[i] = 0;
    for (const Estimate& coefficient : model_.terms[i].coefficients_dph) {
      effects_dph_[i] += coefficient.value * regressors[column++];
    }
    physics_dph_ += effects_dph_[i];
  }
}

}  // namespace fogcomp::model
