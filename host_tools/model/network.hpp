#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/network/network.hpp"
#include "core/thermal/signals.hpp"
#include "model/real_numbers.hpp"

namespace fogcomp {

/// Min-max normalisation of one input: (x - centre) / half_range, clipped to +-1.
struct RealInput {
  fog::NetworkInput signal{};
  double centre = 0;      ///< degC or degC/min
  double half_range = 1;  ///< the same, > 0
};

struct RealLayer {
  Eigen::MatrixXd weights;  ///< outputs x inputs
  Eigen::VectorXd biases;
  fog::Activation activation{};
};

/// The network in double: inputs -> hidden -> y; drift = centre + amplitude * y, deg/h.
struct RealNetwork {
  std::vector<RealInput> inputs;
  RealLayer hidden;
  RealLayer output;
  double centre_dph = 0;
  double amplitude_dph = 0;

  bool present() const { return hidden.biases.size() != 0; }
  double drift_dph(const fog::Signals<RealNumbers>& signals) const;
  /// The normalised inputs.
  Eigen::VectorXd normalised(const fog::Signals<RealNumbers>& signals) const;
};

/// MATLAB's logsig, tansig, purelin.
double activate(fog::Activation activation, double x);
/// Derivative of the activation by its argument, written in its value y.
double activation_slope(fog::Activation activation, double y);

const char* name_of(fog::Activation activation);
const char* name_of(fog::NetworkInput input);

}  // namespace fogcomp
