#include "model/network.hpp"

#include <algorithm>
#include <cmath>

namespace fogcomp {

double activate(fog::Activation activation, double x) {
  switch (activation) {
    case fog::Activation::logsig:
      return 1 / (1 + std::exp(-x));
    case fog::Activation::tansig:
      return std::tanh(x);
    case fog::Activation::linear:
      break;
  }
  return x;
}

double activation_slope(fog::Activation activation, double y) {
  switch (activation) {
    case fog::Activation::logsig:
      return y * (1 - y);
    case fog::Activation::tansig:
      return 1 - y * y;
    case fog::Activation::linear:
      break;
  }
  return 1;
}

const char* name_of(fog::Activation activation) {
  switch (activation) {
    case fog::Activation::logsig:
      return "logsig";
    case fog::Activation::tansig:
      return "tansig";
    case fog::Activation::linear:
      break;
  }
  return "linear";
}

const char* name_of(fog::NetworkInput input) {
  switch (input) {
    case fog::NetworkInput::temperature:
      return "temperature";
    case fog::NetworkInput::temperature_rate:
      return "temperature_rate";
    case fog::NetworkInput::lagged_temperature:
      return "lagged_temperature";
    case fog::NetworkInput::elapsed:
      return "elapsed";
    case fog::NetworkInput::input_rate:
      break;
  }
  return "input_rate";
}

const char* unit_of(fog::NetworkInput input) {
  switch (input) {
    case fog::NetworkInput::temperature:
    case fog::NetworkInput::lagged_temperature:
      break;
    case fog::NetworkInput::temperature_rate:
      return "degC/min";
    case fog::NetworkInput::elapsed:
      return "s";
    case fog::NetworkInput::input_rate:
      return "deg/h";
  }
  return "degC";
}

NetworkSignals::NetworkSignals(const std::vector<RealInput>& inputs, double block_s)
    : inputs_(inputs), block_s_(block_s), values_(static_cast<Eigen::Index>(inputs.size())) {
  for (const RealInput& input : inputs) {
    const bool lagged = input.signal == fog::NetworkInput::lagged_temperature;
    lags_.emplace_back(lagged ? RealNumbers::decay(block_s / input.tau_s) : 0.0);
  }
}

void NetworkSignals::reset(const fog::Signals<RealNumbers>& signals) {
  for (auto& lag : lags_) lag.reset(signals.temperature);
}

const Eigen::VectorXd& NetworkSignals::step(const fog::Signals<RealNumbers>& signals) {
  const auto value = [&](std::size_t i) {
    switch (inputs_[i].signal) {
      case fog::NetworkInput::temperature:
        break;
      case fog::NetworkInput::temperature_rate:
        return signals.temperature_rate;
      case fog::NetworkInput::lagged_temperature:
        return lags_[i].step(signals.temperature);
      case fog::NetworkInput::elapsed:
        return signals.block.elapsed * block_s_;
      case fog::NetworkInput::input_rate:
        return signals.block.input_rate;
    }
    return signals.temperature;
  };
  for (std::size_t i = 0; i < size(); ++i) values_[static_cast<Eigen::Index>(i)] = value(i);
  return values_;
}

Eigen::VectorXd RealNetwork::normalised(const Eigen::VectorXd& values) const {
  Eigen::VectorXd result(values.size());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    result[at] = std::clamp((values[at] - inputs[i].centre) / inputs[i].half_range, -1.0, 1.0);
  }
  return result;
}

fog::InputMask RealNetwork::needs() const {
  fog::NetworkInputMask used = 0;
  for (const RealInput& input : inputs) used |= bit_of(input.signal);
  return fog::needs_of_network(used);
}

double RealNetwork::drift_dph(const Eigen::VectorXd& values) const {
  if (!present()) return 0;
  const auto run = [](const RealLayer& layer, const Eigen::VectorXd& in) -> Eigen::VectorXd {
    return (layer.weights * in + layer.biases).unaryExpr([&](double x) {
      return activate(layer.activation, x);
    });
  };
  return centre_dph + amplitude_dph * run(output, run(hidden, normalised(values)))[0];
}

}  // namespace fogcomp
