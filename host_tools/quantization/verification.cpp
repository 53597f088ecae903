#include "quantization/verification.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/compensation/drift_model.hpp"
#include "model/drift_model.hpp"

namespace fogcomp {
namespace {

// Temperatures of the blocks of a programme: through the whole range and back at several speeds,
// with a soak after each, then jumps. Every value is one that the board can hold, so that only the
// model is compared.
std::vector<fog::Temperature> programme(fog::Temperature least, fog::Temperature most,
                                        double block_s) {
  constexpr double kSoakSeconds = 600;
  constexpr double kRatesDegcPerMin[] = {0.2, 0.5, 1, 3, 10, 30};
  const double low = std::ldexp(least.raw(), -16);
  const double high = std::ldexp(most.raw(), -16);
  std::vector<fog::Temperature> blocks;
  double temperature = low;
  const auto add = [&] {
    blocks.push_back(fog::Temperature::from_raw(
        static_cast<std::int32_t>(std::lround(std::ldexp(temperature, 16)))));
  };
  const auto soak = [&] {
    for (double t = 0; t < kSoakSeconds; t += block_s) add();
  };
  for (const double rate : kRatesDegcPerMin) {
    const double step = rate / 60 * block_s;
    for (; temperature < high; temperature = std::min(high, temperature + step)) add();
    soak();
    for (; temperature > low; temperature = std::max(low, temperature - step)) add();
    soak();
  }
  constexpr int kJumps = 16;
  for (int i = 0; i < kJumps; ++i) {
    temperature = low + (high - low) * ((i * 7) % kJumps) / (kJumps - 1);
    soak();
  }
  return blocks;
}

}  // namespace

QuantizationError verify_quantization(const Model& model, const fog::ModelParameters& parameters) {
  const double block_s =
      static_cast<double>(parameters.sample_period_us) * 1e-6 * parameters.samples_per_block;
  fog::DriftModel<fog::kAllEffects> board(parameters.thermal, parameters.effects,
                                          parameters.network, parameters.policy);
  RealDriftModel real(model, block_s);
  QuantizationError error;
  bool first = true;
  for (const fog::Temperature temperature :
       programme(parameters.thermal.least, parameters.thermal.most, block_s)) {
    const double temperature_degc = std::ldexp(temperature.raw(), -16);
    if (first) {
      board.start({temperature});
      real.start({temperature_degc});
      first = false;
    } else {
      board.step({temperature});
      real.step({temperature_degc});
    }
    const double difference = std::abs(std::ldexp(board.drift().raw(), -10) - real.drift_dph());
    ++error.blocks;
    if (difference > error.worst_dph) {
      error.worst_dph = difference;
      error.at_temperature_degc = temperature_degc;
      error.at_temperature_rate = real.signals().temperature_rate;
    }
  }
  return error;
}

}  // namespace fogcomp
