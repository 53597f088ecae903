#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "board/board_table.hpp"
#include "board/verification.hpp"
#include "model/drift_model.hpp"

namespace fogcomp::board {
namespace {

constexpr double kBeyond = 1.25;        // in half ranges; inputs are clipped at 1
constexpr double kMaxPoints = 200'000;  // of the whole grid
constexpr std::size_t kMaxPerInput = 401;

// Nearest value of the board's format.
std::int32_t board_value(double value, const NetworkInputFormat& format) {
  const double raw = std::round(std::ldexp(value / format.per_unit, format.fraction));
  return static_cast<std::int32_t>(std::clamp(raw, -2147483648.0, 2147483647.0));
}

}  // namespace

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
  std::vector<std::size_t> place(inputs.size(), 0);
  fog::ScaledInputs on_board_inputs{};
  Eigen::VectorXd values(static_cast<Eigen::Index>(inputs.size()));
  for (bool more = true; more;) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const double share =
          2 * static_cast<double>(place[i]) / static_cast<double>(per_input - 1) - 1;
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
    ++error.points;
    more = false;
    for (std::size_t i = 0; i < inputs.size() && !more; ++i) {
      place[i] = (place[i] + 1) % per_input;
      more = place[i] != 0;
    }
  }
  return error;
}

}  // namespace fogcomp::board
