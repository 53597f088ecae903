#include "quantization/verification.hpp"

#include <algorithm>
#include <cmath>

#include "core/compensation/drift_model.hpp"
#include "model/drift_model.hpp"
#include "quantization/board_table.hpp"
#include "quantization/verification_programme.hpp"

namespace fogcomp {

QuantizationError verify_quantization(const Model& model, const fog::ModelParameters& parameters) {
  const double block_s =
      static_cast<double>(parameters.sample_period_us) * 1e-6 * parameters.samples_per_block;
  fog::DriftModel<fog::kAllEffects, fog::kAllNetworkInputs> board(
      parameters.thermal, parameters.effects, parameters.network, parameters.policy);
  const Model real_model = board_model(model);
  RealDriftModel real(real_model, block_s);
  QuantizationError error;
  const auto programme =
      verification_programme(parameters.thermal.least, parameters.thermal.most, block_s);
  for (const auto& block : programme) {
    const RealBlock real_block = to_real(block);
    if (error.blocks == 0) {
      board.start(block);
      real.start(real_block);
    } else {
      board.step(block);
      real.step(real_block);
    }
    const double difference = std::abs(std::ldexp(board.drift().raw(), -10) - real.drift_dph());
    ++error.blocks;
    if (difference > error.worst_dph) {
      error.worst_dph = difference;
      error.at_temperature_degc = real_block.temperature;
      error.at_temperature_rate = real.signals().temperature_rate;
    }
  }
  return error;
}

}  // namespace fogcomp
