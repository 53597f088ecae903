#pragma once
#include <cmath>
#include "dataset/recording.hpp"
#include "evaluation/white_noise.hpp"
namespace fogcomp {
inline double noise_floor_dph(const Recording& r, double a) {
  return white_noise_dph_rthz(r) / std::sqrt(a);
}
}  // namespace fogcomp
