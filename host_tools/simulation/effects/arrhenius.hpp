#pragma once

#include <cmath>

namespace fogcomp::simulation {

/// Factor by which a thermally activated process is faster at `degc` than at 20 degC.
/// `activation_ev`: activation energy, eV.
inline double arrhenius(double activation_ev, double degc) {
  constexpr double kBoltzmannEv = 8.617333262e-5;
  constexpr double kZeroDegcInKelvin = 273.15;
  constexpr double kReferenceK = 293.15;
  return std::exp(activation_ev / kBoltzmannEv *
                  (1 / kReferenceK - 1 / (degc + kZeroDegcInKelvin)));
}

}  // namespace fogcomp::simulation
