#include "denoise/filter_kernels.hpp"

#include <cstring>

#include "denoise/filters.hpp"

namespace fogcomp::denoise {
namespace {

// The sums of kKernelStep outputs, in registers of kLanes doubles. A loop over plain doubles keeps
// them in memory, which takes three times as long. Values are copied as bytes: they may lie
// wherever a double may.
template <std::size_t kLanes>
[[gnu::always_inline]] inline void filter_by(const std::vector<FilterPair::Taps>& taps,
                                             bool backwards, const double* x, const double* y,
                                             std::size_t count, double* first, double* second) {
  using Lanes [[gnu::vector_size(kLanes * sizeof(double))]] = double;
  constexpr std::size_t kParts = kKernelStep / kLanes;
  const std::ptrdiff_t step = backwards ? -1 : 1;
  const std::size_t begin = backwards ? taps.size() - 1 : 0;
  for (std::size_t k = 0; k < count; k += kKernelStep) {
    Lanes first_sum[kParts] = {};
    Lanes second_sum[kParts] = {};
    const double* x_here = x + begin + k;
    const double* y_here = y + begin + k;
    for (const FilterPair::Taps& each : taps) {
      const FilterPair::Taps tap = each;
      for (std::size_t p = 0; p < kParts; ++p) {
        Lanes x_now;
        Lanes y_now;
        std::memcpy(&x_now, x_here + p * kLanes, sizeof x_now);
        std::memcpy(&y_now, y_here + p * kLanes, sizeof y_now);
        first_sum[p] += tap.first_of_x * x_now;
        first_sum[p] += tap.first_of_y * y_now;
        second_sum[p] += tap.second_of_x * x_now;
        second_sum[p] += tap.second_of_y * y_now;
      }
      x_here += step;
      y_here += step;
    }
    std::memcpy(first + k, first_sum, sizeof first_sum);
    std::memcpy(second + k, second_sum, sizeof second_sum);
  }
}

// Compiled for any processor and for AVX2. That has no fused multiply-add, so both give the same
// bits.
#ifdef __x86_64__
[[gnu::target("avx2")]] void filter_by_avx2(const std::vector<FilterPair::Taps>& taps,
                                            bool backwards, const double* x, const double* y,
                                            std::size_t count, double* first, double* second) {
  filter_by<4>(taps, backwards, x, y, count, first, second);
}
const auto kFilter = __builtin_cpu_supports("avx2") != 0 ? filter_by_avx2 : filter_by<2>;
#else
const auto kFilter = filter_by<2>;
#endif

}  // namespace

void filter(const std::vector<FilterPair::Taps>& taps, bool backwards, const double* x,
            const double* y, std::size_t count, double* first, double* second) {
  kFilter(taps, backwards, x, y, count, first, second);
}

FilterPair::FilterPair(const std::vector<double>& lowpass) {
  const std::vector<double> highpass = highpass_filter(lowpass);
  for (std::size_t i = 0; i < lowpass.size(); i += 2) {
    analysis.push_back({lowpass[i], lowpass[i + 1], highpass[i], highpass[i + 1]});
    synthesis.push_back({lowpass[i + 1], highpass[i + 1], lowpass[i], highpass[i]});
  }
}

}  // namespace fogcomp::denoise
