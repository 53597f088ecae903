#include "simulation/truth_writer.hpp"

#include <array>

#include "recording/csv_fields.hpp"
#include "support/text.hpp"

namespace fogcomp::simulation {
namespace {

constexpr int kTimeDecimals = 4;
constexpr int kTemperatureDecimals = 5;
constexpr int kRateDecimals = 7;

}  // namespace

TruthWriter::TruthWriter(const std::string& path, const std::string& origin,
                         const GyroDescription& gyro, const Simulation& simulation)
    : file_(path) {
  file_.write("# " + origin + "\n");
  for (const PartDescription& part : gyro_parts()) {
    file_.write("# part " + part.name + ": " + gyro.part(part.name).text() + "\n");
  }
  for (std::size_t i = 0; i < gyro.effects().size(); ++i) {
    const auto& effect = gyro.effects()[i];
    file_.write("# effect " + effect.description->name + ": " + effect.parameters.text() +
                format(" (scaled by %.10g)\n", simulation.effect_scales()[i]));
  }
  std::string header = "time_s,coil_degc,chamber_degc,input_rate_dph";
  for (const std::string& name : simulation.effect_names()) header += "," + name + "_dph";
  for (const std::string& name : simulation.noise_names()) header += ",noise_" + name + "_dph";
  file_.write(header + "\n");
}

void TruthWriter::append(const RowChunk& chunk) {
  std::string line;
  std::array<char, recording::kLongestDecimal> digits;
  const auto add = [&](double value, int decimals) {
    if (!line.empty()) line += ',';
    line.append(digits.data(), recording::print_fixed(value, decimals, digits.data()));
  };
  for (std::size_t row = 0; row < chunk.rows(); ++row) {
    line.clear();
    add(chunk.time_s[row], kTimeDecimals);
    add(chunk.coil_degc[row], kTemperatureDecimals);
    add(chunk.chamber_degc[row], kTemperatureDecimals);
    add(chunk.input_rate_dph[row], kRateDecimals);
    for (const auto& effect : chunk.effects_dph) add(effect[row], kRateDecimals);
    for (const auto& noise : chunk.noises_dph) add(noise[row], kRateDecimals);
    line += '\n';
    file_.write(line);
  }
}

}  // namespace fogcomp::simulation
