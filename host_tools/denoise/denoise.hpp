#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "denoise/thresholds.hpp"
#include "denoise/transform.hpp"

namespace fogcomp::denoise {

/// Source of the noise's standard deviation.
enum class NoiseFrom : std::uint8_t {
  each_level,    ///< details of the same level: for noise that is not white
  finest_level,  ///< the finest details, for all levels: for white noise and strong signals
};

/// Denoising method.
enum class DenoiseBy : std::uint8_t {
  wavelet,  ///< shrinkage of an orthogonal wavelet's details
  lifting,  ///< the same with the lifting wavelet (2,2): `wavelet` and `extension` are ignored
  kalman,   ///< Kalman smoother with ARMA noise: only remove_outliers applies
};

struct DenoiseMethod {
  DenoiseBy by = DenoiseBy::wavelet;
  std::string wavelet = "sym8";
  int levels = 5;
  ThresholdRule rule = ThresholdRule::heursure;
  bool hard = false;
  NoiseFrom noise = NoiseFrom::each_level;
  Extension extension = Extension::symmetric;
  bool remove_outliers = true;  ///< as a first step: outliers.hpp
};

/// Result of a denoising.
struct DenoiseReport {
  std::size_t outliers = 0;  ///< replaced
  struct Level {
    double noise = 0;      ///< estimated standard deviation, in the unit of the values
    double threshold = 0;  ///< same unit
  };
  std::vector<Level> levels;         ///< the finest first
  std::size_t shortened_values = 0;  ///< in parts too short for all levels (denoise_parts())
};

/// Removes noise from `values` (at least one), in place. Shrinkage shrinks the details of every
/// level and keeps the coarsest approximation; any number of levels (see decompose()).
DenoiseReport denoise(fog::Span<double> values, const DenoiseMethod& method);

}  // namespace fogcomp::denoise
