#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "denoise/thresholds.hpp"
#include "denoise/transform.hpp"

namespace fogcomp::denoise {

/// Where the standard deviation of the noise is taken from.
enum class NoiseFrom : std::uint8_t {
  each_level,    ///< its own details: for noise that is not white
  finest_level,  ///< the finest details, for all levels: for white noise and strong signals
};

/// What takes the noise away.
enum class DenoiseBy : std::uint8_t {
  wavelet,  ///< shrinkage of an orthogonal wavelet's details
  lifting,  ///< the same with the lifting wavelet (2,2): `wavelet` and `extension` do not count
  kalman,   ///< Kalman smoother with ARMA noise: none of the following counts but remove_outliers
};

struct DenoiseMethod {
  DenoiseBy by = DenoiseBy::wavelet;
  std::string wavelet = "sym8";
  int levels = 5;
  ThresholdRule rule = ThresholdRule::heursure;
  bool hard = false;
  NoiseFrom noise = NoiseFrom::each_level;
  Extension extension = Extension::symmetric;
  bool remove_outliers = true;  ///< first: see outliers.hpp
};

/// What was done.
struct DenoiseReport {
  std::size_t outliers = 0;  ///< replaced
  struct Level {
    double noise = 0;      ///< standard deviation found, in the unit of the values
    double threshold = 0;  ///< same unit
  };
  std::vector<Level> levels;         ///< the finest first
  std::size_t shortened_values = 0;  ///< in parts too short for all levels (denoise_parts())
};

/// Removes noise from `values` (at least one), in place. By shrinkage, the details of every level
/// are shrunken and the coarsest approximation stays; any number of levels (see decompose()).
DenoiseReport denoise(fog::Span<double> values, const DenoiseMethod& method);

}  // namespace fogcomp::denoise
