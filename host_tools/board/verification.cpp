#include "board/verification.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "board/board_table.hpp"
#include "board/table_parts.hpp"
#include "core/compensation/drift_model.hpp"
#include "model/drift_model.hpp"

namespace fogcomp::board {
namespace {

constexpr double kRatesDegcPerMin[] = {0.2, 0.5, 1, 3, 10, 30};
constexpr double kSoakSeconds = 600;
constexpr int kJumps = 16;
constexpr double kLoopRateDegcPerMin = 3;
constexpr int kLoops = 5;

using Swing = fog::InputSwing;
constexpr Swing kRateDph{0, 20'000, 1900};
constexpr Swing kTableRateDph{0, 1'000'000'000, 1900};  // in every fourth period

double at(const Swing& swing, double time_s) {
  constexpr double kTwoPi = 6.283185307179586;
  return swing.middle_milli / 1000.0 +
         swing.amplitude_milli / 1000.0 * std::sin(kTwoPi * time_s / swing.period_s);
}

template <class Value>
Value nearest_value(double value) {
  return Value::from_raw(
      static_cast<std::int32_t>(std::lround(std::ldexp(value, Value::fractional_bits))));
}

class Programme {
 public:
  Programme(double low, double high, double block_s)
      : low_(low), high_(high), block_s_(block_s), temperature_(low) {}

  void ramp_to(double target, double rate_degc_per_min) {
    const double step = rate_degc_per_min / 60 * block_s_;
    while (temperature_ != target) {
      add();
      temperature_ += std::clamp(target - temperature_, -step, step);
    }
  }
  void soak() {
    for (double t = 0; t < kSoakSeconds; t += block_s_) add();
  }
  void jump_to(double share) { temperature_ = low_ + (high_ - low_) * share; }
  // Turning points that converge: each loop is inside the one before.
  void loops_about(double share) {
    const double centre = low_ + (high_ - low_) * share;
    for (int loop = kLoops; loop > 0; --loop) {
      const double half_range = (high_ - low_) / 4 * loop / kLoops;
      ramp_to(centre + half_range, kLoopRateDegcPerMin);
      ramp_to(centre - half_range, kLoopRateDegcPerMin);
    }
    soak();
  }
  void skip_years() {
    constexpr double kYears = 5;
    elapsed_ += static_cast<std::int32_t>(kYears * 365 * 86400 / std::max(block_s_, 1.0));
  }

  std::vector<fog::BlockMeans<fog::BoardNumbers>> blocks;

 private:
  void add() {
    const double time_s = static_cast<double>(blocks.size()) * block_s_;
    const bool on_table = std::fmod(time_s / kRateDph.period_s, 4) > 3;
    fog::BlockMeans<fog::BoardNumbers> block;
    block.temperature = nearest_value<fog::Temperature>(temperature_);
    block.input_rate = nearest_value<fog::Rate>(at(on_table ? kTableRateDph : kRateDph, time_s));
    block.elapsed = fog::Elapsed::from_raw(elapsed_++);
    for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
      const fog::Input input = fog::extension_input(i);
      const double base = input == fog::Input::temperature2 ? temperature_ : 0;
      block[input] =
          nearest_value<fog::ExtensionValue>(base + at(description_of(input).swing, time_s));
    }
    blocks.push_back(block);
  }

  double low_;
  double high_;
  double block_s_;
  double temperature_;
  std::int32_t elapsed_ = 0;
};

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

constexpr double kBeyond = 1.25;        // in half ranges; inputs are clipped at 1
constexpr double kMaxPoints = 200'000;  // of the whole grid
constexpr std::size_t kMaxPerInput = 401;

// Nearest value of the board's format.
std::int32_t board_value(double value, const NetworkInputFormat& format) {
  const double raw = std::round(std::ldexp(value / format.per_unit, format.fraction));
  return static_cast<std::int32_t>(std::clamp(raw, -2147483648.0, 2147483647.0));
}

}  // namespace

std::vector<fog::BlockMeans<fog::BoardNumbers>> verification_programme(fog::Temperature min,
                                                                       fog::Temperature max,
                                                                       double block_s) {
  const double low = std::ldexp(min.raw(), -fog::Temperature::fractional_bits);
  const double high = std::ldexp(max.raw(), -fog::Temperature::fractional_bits);
  Programme programme(low, high, block_s);
  for (const double rate : kRatesDegcPerMin) {
    programme.ramp_to(high, rate);
    programme.soak();
    programme.ramp_to(low, rate);
    programme.soak();
  }
  programme.skip_years();
  for (int i = 0; i < kJumps; ++i) {
    programme.jump_to(static_cast<double>((i * 7) % kJumps) / (kJumps - 1));
    programme.soak();
  }
  for (const double share : {0.25, 0.5, 0.75}) programme.loops_about(share);
  return std::move(programme.blocks);
}

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

NetworkError verify_network(const model::Model& model, const fog::ModelParameters& parameters) {
  const double block_s = static_cast<double>(parameters.acquisition.sample_period_us) * 1e-6 *
                         parameters.samples_per_block;
  NetworkError error;
  const std::vector<model::RealInput>& inputs = model.network.inputs;
  if (!model.network.present()) return error;
  // An odd number, so that the centre is included.
  const double even_share = std::pow(kMaxPoints, 1 / static_cast<double>(inputs.size()));
  const std::size_t per_input =
      std::min(kMaxPerInput, static_cast<std::size_t>(even_share)) / 2 * 2 - 1;
  const auto steps = static_cast<double>(per_input - 1);
  const double points = std::pow(steps + 1, inputs.size());
  fog::ScaledInputs on_board_inputs{};
  Eigen::VectorXd values(static_cast<Eigen::Index>(inputs.size()));
  for (; static_cast<double>(error.points) < points; ++error.points) {
    std::size_t place = error.points;
    for (std::size_t i = 0; i < inputs.size(); ++i, place /= per_input) {
      const double share = 2 * static_cast<double>(place % per_input) / steps - 1;
      const NetworkInputFormat format = network_input_format(inputs[i].signal, block_s);
      const std::int32_t raw =
          board_value(inputs[i].centre + kBeyond * share * inputs[i].half_range, format);
      on_board_inputs[i] = fog::scaled_input(raw, parameters.network.inputs[i]).value;
      values[static_cast<Eigen::Index>(i)] = std::ldexp(raw, -format.fraction) * format.per_unit;
    }
    const fog::DriftSum drift = fog::network_drift(parameters.network, on_board_inputs);
    const double on_board =
        std::ldexp(static_cast<double>(drift.raw()), -fog::DriftSum::fractional_bits);
    error.worst_dph =
        std::max(error.worst_dph, std::abs(on_board - model.network.drift_dph(values)));
  }
  return error;
}

}  // namespace fogcomp::board
