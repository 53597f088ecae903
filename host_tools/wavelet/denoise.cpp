#include "wavelet/denoise.hpp"

#include "wavelet/filters.hpp"
#include "wavelet/outliers.hpp"

namespace fogcomp {

DenoiseReport denoise(fog::Span<double> values, const DenoiseMethod& method) {
  const std::vector<double>& lowpass = lowpass_filter(method.wavelet);
  const fog::Span<const double> read_only{values.data, values.size};
  DenoiseReport report;
  if (method.remove_outliers) {
    report.outliers = remove_outliers(values, outlier_limit(read_only));
  }
  Decomposition parts = decompose(read_only, lowpass, method.levels, method.extension);
  for (LargeArray& details : parts.details) {
    const Magnitudes magnitudes({details.data(), details.size()});
    const bool estimate = report.levels.empty() || method.noise == NoiseFrom::each_level;
    const double noise = estimate ? noise_of(magnitudes) : report.levels.front().noise;
    const double threshold = threshold_of(method.rule, magnitudes, details.size(), noise);
    shrink({details.data(), details.size()}, threshold, method.hard);
    report.levels.push_back({noise, threshold});
  }
  reconstruct(parts, lowpass, values);
  return report;
}

}  // namespace fogcomp
