#include "denoise/denoise_parts.hpp"

#include <algorithm>

#include "denoise/filters.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::denoise {
namespace {

constexpr std::size_t kLiftingTaps = 5;

int possible_levels(std::size_t length, const DenoiseMethod& method) {
  switch (method.by) {
    case DenoiseBy::wavelet:
      return max_levels(length, lowpass_filter(method.wavelet).size());
    case DenoiseBy::lifting:
      return max_levels(length, kLiftingTaps);
    case DenoiseBy::kalman:
      break;
  }
  return method.levels;  // has no levels to limit
}

}  // namespace

DenoiseReport denoise_parts(const std::vector<fog::Span<double>>& parts,
                            const DenoiseMethod& method, const std::string& where) {
  std::size_t longest = 0;
  for (const fog::Span<double>& part : parts) longest = std::max(longest, part.size);
  const int possible = possible_levels(longest, method);
  if (possible < method.levels) {
    throw InputError(where, format("%s without a gap: at most %s of %s, not %d; use "
                                   "fewer --levels or a shorter --wavelet",
                                   counted(longest, "value").c_str(),
                                   counted(static_cast<std::size_t>(possible), "level").c_str(),
                                   method.wavelet.c_str(), method.levels));
  }
  DenoiseReport all;
  std::size_t outliers = 0;
  std::size_t shortened = 0;
  for (const fog::Span<double>& part : parts) {
    DenoiseMethod fitting = method;
    fitting.levels = std::min(method.levels, possible_levels(part.size, method));
    if (fitting.levels < method.levels) shortened += part.size;
    DenoiseReport report = denoise(part, fitting);
    outliers += report.outliers;
    if (part.size == longest) all = std::move(report);
  }
  all.outliers = outliers;
  all.shortened_values = shortened;
  return all;
}

}  // namespace fogcomp::denoise
