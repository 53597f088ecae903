#include "network/perceptron.hpp"

#include <cmath>

#include "network/trainer_parts.hpp"

namespace fogcomp::network {

using Eigen::Index;
using Eigen::VectorXd;

model::RealLayer Perceptron::hidden_layer(const VectorXd& weights) const {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  model::RealLayer layer;
  layer.activation = hidden_activation;
  layer.weights = Eigen::Map<const RowMajor>(weights.data(), hidden, inputs);
  layer.biases = weights.segment(hidden_bias(), hidden);
  return layer;
}

model::RealLayer Perceptron::output_layer(const VectorXd& weights) const {
  model::RealLayer layer;
  layer.activation = output_activation;
  layer.weights = weights.segment(output_weight(), hidden).transpose();
  layer.biases = weights.segment(output_bias(), 1);
  return layer;
}

VectorXd Perceptron::first_weights(std::uint64_t seed) const {
  constexpr double kOverlap = 0.7;     // of the neurons' active intervals
  constexpr double kActiveLogsig = 4;  // its curved part is +-4, that of tansig +-2
  constexpr double kOutputWeight = 0.5;
  Uniform uniform(seed);
  const auto neurons = static_cast<double>(hidden);
  const double active =
      hidden_activation == fog::Activation::logsig ? kActiveLogsig : kActiveLogsig / 2;
  const double size = active * kOverlap * std::pow(neurons, 1 / static_cast<double>(inputs));
  VectorXd weights(this->size());
  for (Index j = 0; j < hidden; ++j) {
    auto neuron = weights.segment(hidden_weight(j), inputs);
    for (double& weight : neuron) weight = uniform.within(1);
    neuron *= size / neuron.norm();
    const double place = hidden > 1 ? 2 * static_cast<double>(j) / (neurons - 1) - 1 : 0;
    weights[hidden_bias() + j] = std::copysign(size * place, place * neuron[0]);
    weights[output_weight() + j] = uniform.within(kOutputWeight);
  }
  weights[output_bias()] = 0;
  return weights;
}

}  // namespace fogcomp::network
