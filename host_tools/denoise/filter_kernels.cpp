#include "denoise/filter_kernels.hpp"

#include "denoise/filters.hpp"
#include "support/packs.hpp"

namespace fogcomp {
namespace {

template <class R>
constexpr std::size_t kKernelPacks = kKernelStep / kLanes<R>;

template <class R>
FOGCOMP_INLINE void analyse(const FilterPair& filters, const double* even, const double* odd,
                            std::size_t count, double* low, double* high) {
  const std::size_t phases = filters.taps.size();
  for (std::size_t k = 0; k < count; k += kKernelStep) {
    typename R::Pack low_sum[kKernelPacks<R>] = {};
    typename R::Pack high_sum[kKernelPacks<R>] = {};
    for (std::size_t i = 0; i < phases; ++i) {
      const FilterPair::Taps& tap = filters.taps[i];
      const std::size_t at = k + phases - 1 - i;
      for (std::size_t p = 0; p < kKernelPacks<R>; ++p) {
        const typename R::Pack odd_pack = load<R>(odd + at + p * kLanes<R>);
        const typename R::Pack even_pack = load<R>(even + at + p * kLanes<R>);
        low_sum[p] += tap.low_even * odd_pack;
        low_sum[p] += tap.low_odd * even_pack;
        high_sum[p] += tap.high_even * odd_pack;
        high_sum[p] += tap.high_odd * even_pack;
      }
    }
    for (std::size_t p = 0; p < kKernelPacks<R>; ++p) {
      store<R>(low + k + p * kLanes<R>, low_sum[p]);
      store<R>(high + k + p * kLanes<R>, high_sum[p]);
    }
  }
}

template <class R>
FOGCOMP_INLINE void synthesise(const FilterPair& filters, const double* low, const double* high,
                               std::size_t count, double* even, double* odd) {
  const std::size_t phases = filters.taps.size();
  for (std::size_t k = 0; k < count; k += kKernelStep) {
    typename R::Pack even_sum[kKernelPacks<R>] = {};
    typename R::Pack odd_sum[kKernelPacks<R>] = {};
    for (std::size_t i = 0; i < phases; ++i) {
      const FilterPair::Taps& tap = filters.taps[i];
      for (std::size_t p = 0; p < kKernelPacks<R>; ++p) {
        const typename R::Pack low_pack = load<R>(low + k + i + p * kLanes<R>);
        const typename R::Pack high_pack = load<R>(high + k + i + p * kLanes<R>);
        even_sum[p] += tap.low_odd * low_pack;
        even_sum[p] += tap.high_odd * high_pack;
        odd_sum[p] += tap.low_even * low_pack;
        odd_sum[p] += tap.high_even * high_pack;
      }
    }
    for (std::size_t p = 0; p < kKernelPacks<R>; ++p) {
      store<R>(even + k + p * kLanes<R>, even_sum[p]);
      store<R>(odd + k + p * kLanes<R>, odd_sum[p]);
    }
  }
}

void analyse_portable(const FilterPair& filters, const double* even, const double* odd,
                      std::size_t count, double* low, double* high) {
  analyse<Sse2>(filters, even, odd, count, low, high);
}
void synthesise_portable(const FilterPair& filters, const double* low, const double* high,
                         std::size_t count, double* even, double* odd) {
  synthesise<Sse2>(filters, low, high, count, even, odd);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void analyse_avx2(const FilterPair& filters, const double* even,
                                          const double* odd, std::size_t count, double* low,
                                          double* high) {
  analyse<Avx2>(filters, even, odd, count, low, high);
}
[[gnu::target("avx2")]] void synthesise_avx2(const FilterPair& filters, const double* low,
                                             const double* high, std::size_t count, double* even,
                                             double* odd) {
  synthesise<Avx2>(filters, low, high, count, even, odd);
}
constexpr FilterKernels kAvx2Kernels{analyse_avx2, synthesise_avx2};
#else
constexpr FilterKernels kAvx2Kernels{};
#endif

}  // namespace

const FilterKernels kPortableKernels{analyse_portable, synthesise_portable};

const FilterKernels& best_kernels() {
  static const FilterKernels& best = has_avx2() ? kAvx2Kernels : kPortableKernels;
  return best;
}

FilterPair::FilterPair(const std::vector<double>& lowpass) {
  const std::vector<double> highpass = highpass_filter(lowpass);
  for (std::size_t i = 0; i < lowpass.size(); i += 2) {
    taps.push_back({lowpass[i], lowpass[i + 1], highpass[i], highpass[i + 1]});
  }
}

}  // namespace fogcomp
