#include "wavelet/filters.hpp"

#include <map>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp {
namespace {

// Daubechies, Ten Lectures on Wavelets (1992): least asymmetric. The test "WaveletFilters" checks
// orthonormality and vanishing moments, which leave no digit free.
const std::map<std::string, std::vector<double>>& filters() {
  static const std::map<std::string, std::vector<double>> all{
      {"sym8",
       {-0.0033824159510061256, -0.0005421323317911481, 0.03169508781149298, 0.007607487324917605,
        -0.1432942383508097, -0.061273359067658524, 0.4813596512583722, 0.7771857517005235,
        0.3644418948353314, -0.05194583810770904, -0.027219029917056003, 0.049137179673607506,
        0.003808752013890615, -0.01495225833704823, -0.0003029205147213668,
        0.0018899503327594609}}};
  return all;
}

}  // namespace

const std::vector<double>& lowpass_filter(const std::string& wavelet) {
  const auto found = filters().find(wavelet);
  if (found != filters().end()) return found->second;
  throw InputError("wavelet '" + wavelet + "'",
                   "is unknown" + did_you_mean(wavelet, wavelet_names()));
}

std::vector<std::string> wavelet_names() {
  std::vector<std::string> names;
  for (const auto& filter : filters()) names.push_back(filter.first);
  return names;
}

}  // namespace fogcomp
