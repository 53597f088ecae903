#include "wavelet/filter_kernels.hpp"

#include "wavelet/filters.hpp"

namespace fogcomp {
namespace {

// The registers of a processor: what one holds, and the same in memory, where doubles stand at any
// address.
struct Sse2 {
  using Pack = double __attribute__((vector_size(16)));
  using InMemory = double __attribute__((vector_size(16), aligned(8), may_alias));
};
struct Avx2 {
  using Pack = double __attribute__((vector_size(32)));
  using InMemory = double __attribute__((vector_size(32), aligned(8), may_alias));
};

template <class R>
constexpr std::size_t kLanes = sizeof(typename R::Pack) / sizeof(double);
template <class R>
constexpr std::size_t kPacks = kKernelStep / kLanes<R>;

// The loops exist once; forced inlining compiles them for the target of whoever calls them.
#define FOGCOMP_INLINE [[gnu::always_inline]] inline

template <class R>
FOGCOMP_INLINE void analyse(const FilterPair& filters, const double* even, const double* odd,
                            std::size_t count, double* low, double* high) {
  const std::size_t phases = filters.taps.size();
  for (std::size_t k = 0; k < count; k += kKernelStep) {
    typename R::Pack low_sum[kPacks<R>] = {};
    typename R::Pack high_sum[kPacks<R>] = {};
    for (std::size_t i = 0; i < phases; ++i) {
      const FilterPair::Taps& tap = filters.taps[i];
      const std::size_t at = k + phases - 1 - i;
      for (std::size_t p = 0; p < kPacks<R>; ++p) {
        const typename R::Pack odd_pack =
            *reinterpret_cast<const typename R::InMemory*>(odd + at + p * kLanes<R>);
        const typename R::Pack even_pack =
            *reinterpret_cast<const typename R::InMemory*>(even + at + p * kLanes<R>);
        low_sum[p] += tap.low_even * odd_pack;
        low_sum[p] += tap.low_odd * even_pack;
        high_sum[p] += tap.high_even * odd_pack;
        high_sum[p] += tap.high_odd * even_pack;
      }
    }
    for (std::size_t p = 0; p < kPacks<R>; ++p) {
      *reinterpret_cast<typename R::InMemory*>(low + k + p * kLanes<R>) = low_sum[p];
      *reinterpret_cast<typename R::InMemory*>(high + k + p * kLanes<R>) = high_sum[p];
    }
  }
}

template <class R>
FOGCOMP_INLINE void synthesise(const FilterPair& filters, const double* low, const double* high,
                               std::size_t count, double* even, double* odd) {
  const std::size_t phases = filters.taps.size();
  for (std::size_t k = 0; k < count; k += kKernelStep) {
    typename R::Pack even_sum[kPacks<R>] = {};
    typename R::Pack odd_sum[kPacks<R>] = {};
    for (std::size_t i = 0; i < phases; ++i) {
      const FilterPair::Taps& tap = filters.taps[i];
      for (std::size_t p = 0; p < kPacks<R>; ++p) {
        const typename R::Pack low_pack =
            *reinterpret_cast<const typename R::InMemory*>(low + k + i + p * kLanes<R>);
        const typename R::Pack high_pack =
            *reinterpret_cast<const typename R::InMemory*>(high + k + i + p * kLanes<R>);
        even_sum[p] += tap.low_odd * low_pack;
        even_sum[p] += tap.high_odd * high_pack;
        odd_sum[p] += tap.low_even * low_pack;
        odd_sum[p] += tap.high_even * high_pack;
      }
    }
    for (std::size_t p = 0; p < kPacks<R>; ++p) {
      *reinterpret_cast<typename R::InMemory*>(even + k + p * kLanes<R>) = even_sum[p];
      *reinterpret_cast<typename R::InMemory*>(odd + k + p * kLanes<R>) = odd_sum[p];
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

bool has_avx2() {
  return __builtin_cpu_supports("avx2");
}
#else
constexpr FilterKernels kAvx2Kernels{};

bool has_avx2() {
  return false;
}
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
