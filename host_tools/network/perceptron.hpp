#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "model/network.hpp"

namespace fogcomp::network {

constexpr int kMaxTrainedHidden = 32;

/// inputs -> hidden neurons -> one output, and the order of the weights in the vector that trainers
/// change: hidden weights neuron by neuron, hidden biases, output weights, output bias.
struct Perceptron {
  Eigen::Index inputs = 2;   ///< at least 1
  Eigen::Index hidden = 10;  ///< 1 to kMaxTrainedHidden
  fog::Activation hidden_activation = fog::Activation::logsig;
  fog::Activation output_activation = fog::Activation::tansig;

  Eigen::Index size() const { return hidden * (inputs + 2) + 1; }
  Eigen::Index hidden_weight(Eigen::Index neuron) const { return neuron * inputs; }
  Eigen::Index hidden_bias() const { return hidden * inputs; }
  Eigen::Index output_weight() const { return hidden * (inputs + 1); }
  Eigen::Index output_bias() const { return hidden * (inputs + 2); }

  model::RealLayer hidden_layer(const Eigen::VectorXd& weights) const;
  model::RealLayer output_layer(const Eigen::VectorXd& weights) const;

  /// Initial weights for inputs within +-1 by the rule of Nguyen and Widrow (IJCNN 1990), like
  /// MATLAB's initnw: the curved parts of the hidden neurons are spread over the inputs' range with
  /// some overlap. Output weights within +-0.5.
  Eigen::VectorXd first_weights(std::uint64_t seed) const;
};

}  // namespace fogcomp::network
