#include <Eigen/Core>
#include <cmath>
#include <string>

#include "board/table_parts.hpp"
#include "support/input_error.hpp"

namespace fogcomp::board {
namespace {

// The model's network in the board's form: all neurons tanh(z / 2).
struct BoardNetwork {
  Eigen::MatrixXd weights;  // hidden neurons x inputs
  Eigen::VectorXd biases;
  Eigen::RowVectorXd output_weights;
  double output_bias = 0;
  double centre_dph = 0;
  double amplitude_dph = 0;
};

// tansig(z) = tanh(2 z / 2); logsig(z) = 1/2 + tanh(z / 2) / 2, whose halves are absorbed by the
// next layer.
BoardNetwork board_network(const model::RealNetwork& network) {
  if (network.hidden.activation == fog::Activation::linear) {
    throw InputError("export",
                     "the board has no linear hidden neurons; fit again with logsig or tansig");
  }
  BoardNetwork board{network.hidden.weights,   network.hidden.biases, network.output.weights,
                     network.output.biases[0], network.centre_dph,    network.amplitude_dph};
  if (network.hidden.activation == fog::Activation::tansig) {
    board.weights *= 2;
    board.biases *= 2;
  } else {
    board.output_weights /= 2;
    board.output_bias += board.output_weights.sum();
  }
  if (network.output.activation == fog::Activation::tansig) {
    board.output_weights *= 2;
    board.output_bias *= 2;
  } else if (network.output.activation == fog::Activation::logsig) {
    board.amplitude_dph /= 2;
    board.centre_dph += board.amplitude_dph;
  }
  return board;
}

// Largest fraction with which all weights fit 32 bits and all sums 64 (fog::network_fits), rounding
// included.
int weight_fraction(const Eigen::MatrixXd& weights, const Eigen::VectorXd& biases) {
  const double largest_sum =
      (weights.cwiseAbs().rowwise().sum() + biases.cwiseAbs() / 2).maxCoeff();
  const double largest = std::max(weights.cwiseAbs().maxCoeff(), largest_sum / 2);
  return fraction_within(largest * 1.001, fog::kWeightFraction - fog::kMaxWeightShift,
                         fog::kWeightFraction);
}

// Returns the remaining factor for this input's weights.
double write_input(TableWriter& out, const model::RealInput& input, double block_s) {
  const std::string lag = input.tau_s > 0 ? format(" (tau %g s)", input.tau_s) : "";
  out.note(format("input %s%s: (x - %.9g) / %.9g %s; signal, decay, centre, half range, shift",
                  model::name_of(input.signal), lag.c_str(), input.centre, input.half_range,
                  description_of(input_of(input.signal)).unit));
  out.integer(static_cast<std::int32_t>(input.signal), "input signal");
  out.real(input.tau_s > 0 ? model::RealNumbers::decay(block_s / input.tau_s) : 0, 31,
           "an input's decay");
  const NetworkInputFormat board = network_input_format(input.signal, block_s);
  const double half_range = std::ldexp(input.half_range / board.per_unit, board.fraction);
  if (half_range < 1)
    throw InputError("export", format("an input's half range %g is below the board's resolution",
                                      input.half_range));
  const int shift = fraction_within(std::round(half_range), 0, 30);
  out.real(input.centre / board.per_unit, board.fraction, "an input's centre");
  out.real(half_range, 0, "an input's half range");
  out.integer(shift, "an input's shift");
  return std::ldexp(1 / half_range, 30 - shift);
}

}  // namespace

NetworkInputFormat network_input_format(fog::NetworkInput signal, double block_s) {
  const fog::Input input = input_of(signal);
  return {description_of(input).fraction, input == fog::Input::elapsed ? block_s : 1};
}

void write_network(TableWriter& out, const model::RealNetwork& network, double block_s) {
  const std::size_t inputs = network.present() ? network.inputs.size() : 0;
  out.note("network: inputs, hidden neurons");
  out.integer(static_cast<std::int64_t>(inputs), "network inputs");
  out.integer(network.hidden.biases.size(), "hidden neurons");
  if (!network.present()) return;
  BoardNetwork board = board_network(network);
  for (std::size_t i = 0; i < inputs; ++i) {
    board.weights.col(static_cast<Eigen::Index>(i)) *= write_input(out, network.inputs[i], block_s);
  }
  const int hidden = weight_fraction(board.weights, board.biases);
  const int output =
      weight_fraction(board.output_weights, Eigen::VectorXd::Constant(1, board.output_bias));
  out.note("fractional bits that large weights cost: hidden neurons, output");
  out.integer(fog::kWeightFraction - hidden, "hidden neurons' shift");
  out.integer(fog::kWeightFraction - output, "the output's shift");
  out.note(format("hidden neurons (%s): bias, %d weights, weight in the output",
                  model::name_of(network.hidden.activation),
                  static_cast<int>(fog::kMaxNetworkInputs)));
  for (Eigen::Index row = 0; row < board.weights.rows(); ++row) {
    out.real(board.biases[row], hidden - 2, "a bias");
    for (std::size_t i = 0; i < fog::kMaxNetworkInputs; ++i) {
      const double weight = i < inputs ? board.weights(row, static_cast<Eigen::Index>(i)) : 0;
      out.real(weight, hidden, "a weight");
    }
    out.real(board.output_weights[row], output, "an output weight");
  }
  out.note(format("output (%s): bias, 1 if linear", model::name_of(network.output.activation)));
  out.real(board.output_bias, output - 2, "the output's bias");
  out.integer(network.output.activation == fog::Activation::linear ? 1 : 0, "the output's kind");
  out.note(format("drift = %.9g + %.9g y deg/h", board.centre_dph, board.amplitude_dph));
  out.real<fog::NetworkDrift>(board.centre_dph, "the network's centre");
  out.real<fog::NetworkDrift>(board.amplitude_dph, "the network's amplitude");
}

}  // namespace fogcomp::board
