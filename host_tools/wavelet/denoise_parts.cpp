#include "wavelet/denoise_parts.hpp"

#include <algorithm>

#include "support/input_error.hpp"
#include "support/text.hpp"
#include "wavelet/filters.hpp"

namespace fogcomp {

DenoiseReport denoise_parts(const std::vector<fog::Span<double>>& parts,
                            const DenoiseMethod& method, const std::string& where) {
  const std::size_t taps = lowpass_filter(method.wavelet).size();
  std::size_t longest = 0;
  for (const fog::Span<double>& part : parts) longest = std::max(longest, part.size);
  const int possible = most_levels(longest, taps);
  if (possible < method.levels) {
    throw InputError(where, format("%zu rows without a gap allow %d levels of %s, not %d; use "
                                   "fewer --levels or a shorter --wavelet",
                                   longest, possible, method.wavelet.c_str(), method.levels));
  }
  DenoiseReport all;
  std::size_t outliers = 0;
  std::size_t shortened = 0;
  for (const fog::Span<double>& part : parts) {
    DenoiseMethod fitting = method;
    fitting.levels = std::min(method.levels, most_levels(part.size, taps));
    if (fitting.levels < method.levels) shortened += part.size;
    DenoiseReport report = denoise(part, fitting);
    outliers += report.outliers;
    if (part.size == longest) all = std::move(report);
  }
  all.outliers = outliers;
  all.shortened_values = shortened;
  return all;
}

}  // namespace fogcomp
