#include "identification/independent_rows.hpp"

#include <cmath>

namespace fogcomp {

double independent_share(const NoiseModel& noise) {
  constexpr double kPeriod = 3600;  // s
  constexpr double kTwoPi = 6.283185307179586;
  double density = noise.white_variance;
  for (const NoiseModel::Component& component : noise.components) {
    const double phi = std::exp(-noise.row_s / component.tau_s);
    const double cosine = std::cos(kTwoPi * noise.row_s / kPeriod);
    density += component.variance * (1 - phi * phi) / (1 - 2 * phi * cosine + phi * phi);
  }
  return density > 0 ? noise.white_variance / density : 1;
}

}  // namespace fogcomp
