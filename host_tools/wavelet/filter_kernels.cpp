#include "wavelet/filter_kernels.hpp"

#include "wavelet/filters.hpp"

namespace fogcomp {
namespace {

// Four doubles; the compiler makes one AVX register of it, or two of SSE2.
using Pack = double __attribute__((vector_size(32)));
// The same in memory, where doubles stand at any address.
using PackInMemory = double __attribute__((vector_size(32), aligned(8), may_alias));
constexpr std::size_t kLanes = 4;
constexpr std::size_t kPacks = kKernelStep / kLanes;

const PackInMemory& pack_at(const double* values) {
  return *reinterpret_cast<const PackInMemory*>(values);
}
PackInMemory& pack_at(double* values) {
  return *reinterpret_cast<PackInMemory*>(values);
}

// The loops exist once; forced inlining compiles them for the target of whoever calls them.
#define FOGCOMP_INLINE [[gnu::always_inline]] inline

FOGCOMP_INLINE void analyse(const FilterPair& filters, const double* even, const double* odd,
                            std::size_t count, double* low, double* high) {
  const std::size_t phases = filters.taps.size();
  for (std::size_t k = 0; k < count; k += kKernelStep) {
    Pack low_sum[kPacks] = {};
    Pack high_sum[kPacks] = {};
    for (std::size_t i = 0; i < phases; ++i) {
      const FilterPair::Taps& tap = filters.taps[i];
      const std::size_t at = k + phases - 1 - i;
      for (std::size_t p = 0; p < kPacks; ++p) {
        const Pack odd_pack = pack_at(odd + at + p * kLanes);
        const Pack even_pack = pack_at(even + at + p * kLanes);
        low_sum[p] += tap.low_even * odd_pack;
        low_sum[p] += tap.low_odd * even_pack;
        high_sum[p] += tap.high_even * odd_pack;
        high_sum[p] += tap.high_odd * even_pack;
      }
    }
    for (std::size_t p = 0; p < kPacks; ++p) {
      pack_at(low + k + p * kLanes) = low_sum[p];
      pack_at(high + k + p * kLanes) = high_sum[p];
    }
  }
}

FOGCOMP_INLINE void synthesise(const FilterPair& filters, const double* low, const double* high,
                               std::size_t count, double* even, double* odd) {
  const std::size_t phases = filters.taps.size();
  for (std::size_t k = 0; k < count; k += kKernelStep) {
    Pack even_sum[kPacks] = {};
    Pack odd_sum[kPacks] = {};
    for (std::size_t i = 0; i < phases; ++i) {
      const FilterPair::Taps& tap = filters.taps[i];
      for (std::size_t p = 0; p < kPacks; ++p) {
        const Pack low_pack = pack_at(low + k + i + p * kLanes);
        const Pack high_pack = pack_at(high + k + i + p * kLanes);
        even_sum[p] += tap.low_odd * low_pack;
        even_sum[p] += tap.high_odd * high_pack;
        odd_sum[p] += tap.low_even * low_pack;
        odd_sum[p] += tap.high_even * high_pack;
      }
    }
    for (std::size_t p = 0; p < kPacks; ++p) {
      pack_at(even + k + p * kLanes) = even_sum[p];
      pack_at(odd + k + p * kLanes) = odd_sum[p];
    }
  }
}

void analyse_portable(const FilterPair& filters, const double* even, const double* odd,
                      std::size_t count, double* low, double* high) {
  analyse(filters, even, odd, count, low, high);
}
void synthesise_portable(const FilterPair& filters, const double* low, const double* high,
                         std::size_t count, double* even, double* odd) {
  synthesise(filters, low, high, count, even, odd);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void analyse_avx2(const FilterPair& filters, const double* even,
                                          const double* odd, std::size_t count, double* low,
                                          double* high) {
  analyse(filters, even, odd, count, low, high);
}
[[gnu::target("avx2")]] void synthesise_avx2(const FilterPair& filters, const double* low,
                                             const double* high, std::size_t count, double* even,
                                             double* odd) {
  synthesise(filters, low, high, count, even, odd);
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
