#include "denoise/filters.hpp"

#include "denoise/filter_tables.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::denoise {

const std::vector<double>& lowpass_filter(const std::string& wavelet) {
  for (const FilterTable* table : {&kDaubechies, &kSymlets, &kCoiflets}) {
    for (const auto& [name, taps] : *table) {
      if (name == wavelet) return taps;
    }
  }
  throw InputError("wavelet '" + wavelet + "'",
                   "is unknown" + did_you_mean(wavelet, wavelet_names()));
}

std::vector<double> highpass_filter(const std::vector<double>& lowpass) {
  std::vector<double> highpass(lowpass.rbegin(), lowpass.rend());
  for (std::size_t i = 0; i < highpass.size(); i += 2) highpass[i] = -highpass[i];
  return highpass;
}

const std::vector<std::string>& wavelet_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const FilterTable* table : {&kDaubechies, &kSymlets, &kCoiflets}) {
      for (const auto& filter : *table) all.push_back(filter.first);
    }
    return all;
  }();
  return names;
}

}  // namespace fogcomp::denoise
