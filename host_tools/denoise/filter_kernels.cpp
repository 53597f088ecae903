#include "denoise/filter_kernels.hpp"

#include "denoise/filters.hpp"

namespace fogcomp::denoise {

void analyse(const FilterPair& filters, const double* even, const double* odd, std::size_t count,
             double* low, double* high) {
  const std::size_t phases = filters.taps.size();
  for (std::size_t k = 0; k < count; k += kKernelStep) {
    double low_sum[kKernelStep] = {};
    double high_sum[kKernelStep] = {};
    for (std::size_t i = 0; i < phases; ++i) {
      const FilterPair::Taps tap = filters.taps[i];
      const std::size_t at = k + phases - 1 - i;
      for (std::size_t p = 0; p < kKernelStep; ++p) {
        low_sum[p] += tap.low_even * odd[at + p];
        low_sum[p] += tap.low_odd * even[at + p];
        high_sum[p] += tap.high_even * odd[at + p];
        high_sum[p] += tap.high_odd * even[at + p];
      }
    }
    for (std::size_t p = 0; p < kKernelStep; ++p) {
      low[k + p] = low_sum[p];
      high[k + p] = high_sum[p];
    }
  }
}

void synthesise(const FilterPair& filters, const double* low, const double* high, std::size_t count,
                double* even, double* odd) {
  const std::size_t phases = filters.taps.size();
  for (std::size_t k = 0; k < count; k += kKernelStep) {
    double even_sum[kKernelStep] = {};
    double odd_sum[kKernelStep] = {};
    for (std::size_t i = 0; i < phases; ++i) {
      const FilterPair::Taps tap = filters.taps[i];
      for (std::size_t p = 0; p < kKernelStep; ++p) {
        even_sum[p] += tap.low_odd * low[k + i + p];
        even_sum[p] += tap.high_odd * high[k + i + p];
        odd_sum[p] += tap.low_even * low[k + i + p];
        odd_sum[p] += tap.high_even * high[k + i + p];
      }
    }
    for (std::size_t p = 0; p < kKernelStep; ++p) {
      even[k + p] = even_sum[p];
      odd[k + p] = odd_sum[p];
    }
  }
}

FilterPair::FilterPair(const std::vector<double>& lowpass) {
  const std::vector<double> highpass = highpass_filter(lowpass);
  for (std::size_t i = 0; i < lowpass.size(); i += 2) {
    taps.push_back({lowpass[i], lowpass[i + 1], highpass[i], highpass[i + 1]});
  }
}

}  // namespace fogcomp::denoise
