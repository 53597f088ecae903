#include "gyro_draw.hpp"

#include <algorithm>
#include <cmath>

#include "support/text.hpp"

namespace fogcomp::bench {
namespace {

constexpr double kRow_h = 10.0 / 3600;

std::string coil(Draws& draws) {
  return draws.pick(std::vector<std::string>{
      "coil",  // Li 2015
      "coil:layers=64,turns=90,outer_radius_mm=63.8,height_mm=17.2",
      "coil:layers=24,turns=40,inner_radius_mm=30,outer_radius_mm=33.3,height_mm=7.6",
  });
}

std::string housing(Draws& draws) {
  std::string option =
      format("housing:housing_j_per_k=%.0f,to_air_w_per_k=%.3f,self_heating_w=%.2f",
             draws.ratio(350, 1000), draws.ratio(0.4, 1.1), draws.uniform(0.3, 3));
  if (draws.chance(0.25)) option += format(",slab_kg=%.1f", draws.uniform(2, 20));
  return option;
}

std::string sensor(Draws& draws) {
  const double resolution_k = draws.pick(std::vector<double>{0.01, 0.015625, 0.03125, 0.0625});
  return format("sensor:lag_s=%.1f,resolution_k=%g,noise_k=%.4f", draws.ratio(2, 20), resolution_k,
                draws.uniform(0.005, 0.03));
}

double flicker_dph(Draws& draws, Flicker flicker) {
  switch (flicker) {
    case Flicker::none:
      break;
    case Flicker::weak:
      return draws.ratio(0.0005, 0.0015);
    case Flicker::strong:
      return draws.ratio(0.0025, 0.004);
  }
  return 0;
}

// A further effect that the engineer already knows.
void declare_one_more(Draws& draws, DrawnGyro& gyro, const std::vector<std::string>& hidden) {
  const auto name = draws.pick(
      std::vector<std::string>{"warm_up", "temperature_rate_product", "polarization_ripple"});
  if (std::find(hidden.begin(), hidden.end(), name) != hidden.end()) return;
  gyro.declared.push_back(name);
  if (name == "warm_up") {
    gyro.effects.push_back(format("warm_up:amplitude_dph=%.4f,tau_s=%.0f",
                                  draws.sign() * draws.ratio(0.02, 0.08), draws.ratio(600, 2400)));
  } else if (name == "temperature_rate_product") {
    gyro.effects.push_back(format("temperature_rate_product:coefficient=%.3e",
                                  draws.sign() * draws.ratio(2e-4, 1e-3)));
  } else {
    gyro.effects.push_back(
        format("polarization_ripple:amplitude_dph=%.4f,period_k=%.2f,"
               "phase_deg=%.0f,second=0.05",
               draws.ratio(0.01, 0.04), draws.ratio(8, 40), draws.uniform(-180, 180)));
  }
}

}  // namespace

double DrawnGyro::row_noise_dph() const {
  return white_dprh / std::sqrt(kRow_h);
}

std::string DrawnGyro::noise_option() const {
  // Outliers as often and as large as those of the preset `paper`.
  return format("white=%.6f,flicker=%.6f,outliers=0.2,outlier_dph=4", white_dprh, flicker_dph);
}

DrawnGyro draw_gyro(Draws& draws, Flicker flicker, const std::vector<std::string>& hidden) {
  const auto is_hidden = [&](const char* name) {
    return std::find(hidden.begin(), hidden.end(), name) != hidden.end();
  };
  DrawnGyro gyro;
  gyro.parts = {coil(draws), housing(draws), sensor(draws)};
  gyro.white_dprh = draws.ratio(0.0008, 0.003);
  gyro.flicker_dph = flicker_dph(draws, flicker);

  gyro.effects.push_back(format("bias:value_dph=%.4f", draws.sign() * draws.ratio(0.02, 1)));
  gyro.declared.emplace_back("bias");

  // The order in the model; the simulator's polynomial is cubic.
  const int order = (is_hidden("bias_temperature") ? 1 : 2) + (draws.chance(0.5) ? 1 : 0);
  std::string polynomial =
      format("bias_temperature:slope=%.3e", draws.sign() * draws.ratio(1e-4, 1e-3));
  if (order >= 2) polynomial += format(",curvature=%.3e", draws.sign() * draws.ratio(1e-6, 3e-5));
  if (order >= 3) polynomial += format(",cubic=%.3e", draws.sign() * draws.ratio(1e-8, 2e-7));
  gyro.effects.push_back(polynomial);
  gyro.declared.push_back(format("bias_temperature:order=%d", order));

  if (!is_hidden("temperature_rate") && draws.chance(0.85)) {
    gyro.effects.push_back(
        format("temperature_rate:coefficient=%.4f", draws.sign() * draws.ratio(0.02, 0.2)));
    gyro.declared.emplace_back("temperature_rate");
  }
  if (draws.chance(0.25)) declare_one_more(draws, gyro, hidden);
  return gyro;
}

}  // namespace fogcomp::bench
