#include "denoise/denoise.hpp"

#include "denoise/filters.hpp"
#include "denoise/kalman_arma.hpp"
#include "denoise/lifting.hpp"
#include "denoise/outliers.hpp"

namespace fogcomp::denoise {
namespace {

// Shrinks the levels, finest first.
class Shrinkage {
 public:
  Shrinkage(const DenoiseMethod& method, DenoiseReport& report)
      : method_(method), report_(report) {}

  void operator()(fog::Span<double> details) {
    const fog::Span<const double> level{details.data, details.size};
    const bool estimate = report_.levels.empty() || method_.noise == NoiseFrom::each_level;
    const double noise = estimate ? noise_of(level) : report_.levels.front().noise;
    const double threshold = threshold_of(method_.rule, level, noise);
    shrink(details, threshold, method_.hard);
    report_.levels.push_back({noise, threshold});
  }

 private:
  const DenoiseMethod& method_;
  DenoiseReport& report_;
};

void shrink_wavelet(fog::Span<double> values, const DenoiseMethod& method, DenoiseReport& report) {
  const std::vector<double>& lowpass = lowpass_filter(method.wavelet);
  Decomposition parts = decompose(values, lowpass, method.levels, method.extension);
  Shrinkage shrinkage(method, report);
  for (const fog::Span<double> details : parts.details) shrinkage(details);
  reconstruct(parts, lowpass, values);
}

void shrink_lifting(fog::Span<double> values, const DenoiseMethod& method, DenoiseReport& report) {
  LiftingParts parts = lift({values.data, values.size}, method.levels);
  Shrinkage shrinkage(method, report);
  for (std::vector<double>& details : parts.details) shrinkage({details.data(), details.size()});
  unlift(parts, values);
}

}  // namespace

DenoiseReport denoise(fog::Span<double> values, const DenoiseMethod& method) {
  DenoiseReport report;
  if (method.remove_outliers) {
    report.outliers = remove_outliers(values, outlier_limit({values.data, values.size}));
  }
  switch (method.by) {
    case DenoiseBy::wavelet:
      shrink_wavelet(values, method, report);
      break;
    case DenoiseBy::lifting:
      shrink_lifting(values, method, report);
      break;
    case DenoiseBy::kalman:
      kalman_smooth(values);
      break;
  }
  return report;
}

}  // namespace fogcomp::denoise
