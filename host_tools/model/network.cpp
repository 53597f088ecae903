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
      break;
  }
  return "temperature_rate";
}

Eigen::VectorXd RealNetwork::normalised(const fog::Signals<RealNumbers>& signals) const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(inputs.size()));
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double x = inputs[i].signal == fog::NetworkInput::temperature ? signals.temperature
                                                                        : signals.temperature_rate;
    values[static_cast<Eigen::Index>(i)] =
        std::clamp((x - inputs[i].centre) / inputs[i].half_range, -1.0, 1.0);
  }
  return values;
}

double RealNetwork::drift_dph(const fog::Signals<RealNumbers>& signals) const {
  if (!present()) return 0;
  const auto run = [](const RealLayer& layer, const Eigen::VectorXd& in) -> Eigen::VectorXd {
    return (layer.weights * in + layer.biases).unaryExpr([&](double x) {
      return activate(layer.activation, x);
    });
  };
  return centre_dph + amplitude_dph * run(output, run(hidden, normalised(signals)))[0];
}

}  // namespace fogcomp
