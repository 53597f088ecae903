#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "core/network/network.hpp"
#include "core/thermal/first_order_lag.hpp"
#include "core/thermal/signals.hpp"
#include "model/real_numbers.hpp"

namespace fogcomp::model {

/// An input of the network and its min-max normalisation: (x - centre) / half_range, clipped to
/// +-1. In the input's unit (kInputTable).
struct RealInput {
  fog::NetworkInput signal{};
  double centre = 0;
  double half_range = 1;  ///< > 0
  double tau_s = 0;       ///< of lagged_temperature; 0 for the others
};

/// Values of network inputs block by block, in their units: the inputs of the board's DriftNetwork
/// in double, without normalisation.
class NetworkSignals {
 public:
  NetworkSignals(const std::vector<RealInput>& inputs, double block_s);

  std::size_t size() const { return inputs_.size(); }
  void reset(const fog::Signals<RealNumbers>& signals);
  /// Advances by one block; the result is valid until the next call.
  const Eigen::VectorXd& step(const fog::Signals<RealNumbers>& signals);

 private:
  std::vector<RealInput> inputs_;
  double block_s_;
  std::vector<fog::FirstOrderLag<RealNumbers>> lags_;  // one per input; only lagged ones are used
  Eigen::VectorXd values_;
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
  /// 0 without a network. `values`: one per input, from NetworkSignals.
  double drift_dph(const Eigen::VectorXd& values) const;
  Eigen::VectorXd normalised(const Eigen::VectorXd& values) const;
  /// Inputs that it needs beside the coil temperature.
  fog::InputMask needs() const;
};

/// MATLAB's logsig, tansig, purelin.
double activate(fog::Activation activation, double x);

const char* name_of(fog::Activation activation);
const char* name_of(fog::NetworkInput input);
/// All inputs, in the order of their numbers.
inline constexpr auto kEveryNetworkInput = [] {
  std::array<fog::NetworkInput, fog::kNetworkInputs> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<fog::NetworkInput>(i);
  return all;
}();
std::vector<std::string> network_input_names();

}  // namespace fogcomp::model
