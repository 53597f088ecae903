#include <algorithm>
#include <cmath>
#include <vector>

#include "model/drift_model.hpp"
#include "quantization/verification.hpp"

namespace fogcomp {
namespace {

constexpr double kBeyond = 1.25;         // half ranges: inputs are clipped at 1
constexpr double kMostPoints = 200'000;  // of the whole grid
constexpr std::size_t kMostPerInput = 401;

// The nearest value that the board's format holds, within what the stage before delivers.
template <class Value>
Value board_value(double value, double most) {
  const double clipped = std::clamp(value, -most, most);
  return Value::from_raw(
      static_cast<std::int32_t>(std::lround(std::ldexp(clipped, Value::fractional_bits))));
}

template <class Value>
double real(Value value) {
  return std::ldexp(value.raw(), -Value::fractional_bits);
}

struct Point {
  fog::Signals<fog::BoardNumbers> board;
  fog::Signals<RealNumbers> exact;

  void set(fog::NetworkInput input, double value) {
    constexpr double kMostDegc = 1000;
    constexpr double kMostRate = 32;
    switch (input) {
      case fog::NetworkInput::temperature:
        board.temperature = board_value<fog::Temperature>(value, kMostDegc);
        exact.temperature = real(board.temperature);
        return;
      case fog::NetworkInput::temperature_rate:
        board.temperature_rate = board_value<fog::TemperatureRate>(value, kMostRate);
        exact.temperature_rate = real(board.temperature_rate);
        return;
    }
  }
};

}  // namespace

NetworkError verify_network(const Model& model, const fog::ModelParameters& parameters) {
  NetworkError error;
  const std::vector<RealInput>& inputs = model.network.inputs;
  if (!model.network.present()) return error;
  // An odd number, so that the centre is among them.
  const double even_share = std::pow(kMostPoints, 1 / static_cast<double>(inputs.size()));
  const std::size_t per_input =
      std::min(kMostPerInput, static_cast<std::size_t>(even_share)) / 2 * 2 - 1;
  std::vector<std::size_t> place(inputs.size(), 0);
  Point point;
  for (bool more = true; more;) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const double share =
          2 * static_cast<double>(place[i]) / static_cast<double>(per_input - 1) - 1;
      point.set(inputs[i].signal, inputs[i].centre + kBeyond * share * inputs[i].half_range);
    }
    const fog::DriftSum drift = fog::network_drift(
        parameters.network, parameters.effects.coefficient_fraction, point.board);
    const double on_board =
        std::ldexp(static_cast<double>(drift.raw()), -fog::DriftSum::fractional_bits);
    error.worst_dph =
        std::max(error.worst_dph, std::abs(on_board - model.network.drift_dph(point.exact)));
    ++error.points;
    more = false;
    for (std::size_t i = 0; i < inputs.size() && !more; ++i) {
      place[i] = (place[i] + 1) % per_input;
      more = place[i] != 0;
    }
  }
  return error;
}

}  // namespace fogcomp
