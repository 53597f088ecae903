#include "model/network.hpp"

#include <algorithm>
#include <cmath>

#include "model/input_value.hpp"

namespace fogcomp::model {

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
  return input == fog::NetworkInput::lagged_temperature ? "lagged_temperature"
                                                        : description_of(input_of(input)).name;
}

std::vector<std::string> network_input_names() {
  std::vector<std::string> names;
  for (const fog::NetworkInput input : kEveryNetworkInput) names.emplace_back(name_of(input));
  return names;
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
  for (std::size_t i = 0; i < size(); ++i) {
    const fog::NetworkInput input = inputs_[i].signal;
    values_[static_cast<Eigen::Index>(i)] = input == fog::NetworkInput::lagged_temperature
                                                ? lags_[i].step(signals.temperature)
                                                : value_of(input_of(input), signals, block_s_);
  }
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
  return fog::beside_temperature(fog::inputs_of_network(used));
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

}  // namespace fogcomp::model
