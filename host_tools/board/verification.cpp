#include "board/verification.hpp"

#include <algorithm>
#include <cmath>

#include "board/board_table.hpp"
#include "board/expression_code.hpp"
#include "board/verification_programme.hpp"
#include "core/compensation/drift_model.hpp"
#include "model/drift_model.hpp"

namespace fogcomp::board {

namespace {

// Compares the expressions of a model with the same in double, over the same blocks.
class ExpressionCheck {
 public:
  ExpressionCheck(const model::Model& model, const fog::ModelParameters& parameters, double block_s)
      : board_thermal_(parameters.thermal),
        real_thermal_(model::thermal_parameters(model, block_s)),
        board_(parameters.expressions, parameters.effects.coefficient_fraction) {
    for (const model::EffectTerm& term : model.terms) {
      if (!term.expression) continue;
      const double size = std::abs(term.coefficients_dph[0].value);
      results.push_back({term.name, compile_expression(term, model, block_s).error * size, 0});
      sizes_.push_back(size);
      real_.push_back(model::make_effect(term, block_s));
    }
  }

  void start(const fog::BlockMeans<fog::BoardNumbers>& block) {
    board_.reset(board_thermal_.reset(block));
    const auto signals = real_thermal_.reset(model::to_real(block));
    for (const auto& real : real_) real->reset(signals);
  }
  void step(const fog::BlockMeans<fog::BoardNumbers>& block) {
    board_.step(board_thermal_.step(block));
    const auto signals = real_thermal_.step(model::to_real(block));
    for (std::size_t i = 0; i < real_.size(); ++i) {
      double expected = 0;
      real_[i]->step(signals, &expected);
      const double max = std::ldexp(1, 31 - fog::Regressor::fractional_bits);
      const double got = std::ldexp(board_.regressors()[i].raw(), -fog::Regressor::fractional_bits);
      results[i].worst_dph = std::max(results[i].worst_dph,
                                      sizes_[i] * std::abs(got - std::clamp(expected, -max, max)));
    }
  }

  std::vector<QuantizationError::Expression> results;

 private:
  fog::ThermalState<fog::BoardNumbers> board_thermal_;
  fog::ThermalState<model::RealNumbers> real_thermal_;
  fog::ExpressionBank<fog::kAllExpressions> board_;
  std::vector<std::unique_ptr<model::RealEffect>> real_;
  std::vector<double> sizes_;
};

}  // namespace

QuantizationError verify_quantization(const model::Model& model,
                                      const fog::ModelParameters& parameters) {
  const double block_s = static_cast<double>(parameters.acquisition.sample_period_us) * 1e-6 *
                         parameters.samples_per_block;
  fog::DriftModel<fog::kAllEffects, fog::kAllExpressions, fog::kAllNetworkInputs> board(
      parameters.thermal, parameters.effects, parameters.expressions, parameters.network,
      parameters.policy);
  const model::Model real_model = board_model(model);
  model::RealDriftModel real(real_model, block_s);
  QuantizationError error;
  ExpressionCheck expressions(real_model, parameters, block_s);
  const auto programme =
      verification_programme(parameters.thermal.min, parameters.thermal.max, block_s);
  for (const auto& block : programme) {
    const model::RealBlock real_block = model::to_real(block);
    if (error.blocks == 0) {
      board.start(block);
      real.start(real_block);
      expressions.start(block);
    } else {
      board.step(block);
      real.step(real_block);
      expressions.step(block);
    }
    const double difference = std::abs(std::ldexp(board.drift().raw(), -10) - real.drift_dph());
    ++error.blocks;
    if (difference > error.worst_dph) {
      error.worst_dph = difference;
      error.at_temperature_degc = real_block.temperature;
      error.at_temperature_rate = real.signals().temperature_rate;
    }
  }
  error.expressions = std::move(expressions.results);
  return error;
}

}  // namespace fogcomp::board
