#include "denoise/filter_kernels.hpp"

#include "denoise/filters.hpp"

namespace fogcomp::denoise {
namespace {

// kLanes doubles of a register, read from and written to wherever a double may lie.
template <std::size_t kLanes>
struct Register {
  using Type
      [[gnu::vector_size(kLanes * sizeof(double)), gnu::aligned(alignof(double)), gnu::may_alias]] =
          double;
  static const Type& at(const double* values) { return *reinterpret_cast<const Type*>(values); }
  static Type& at(double* values) { return *reinterpret_cast<Type*>(values); }
};

// The sums of kKernelStep outputs, in as many registers as that takes. A loop over plain doubles
// keeps them in memory, which takes three times as long.
template <std::size_t kLanes>
[[gnu::always_inline]] inline void analyse_by(const FilterPair& filters, const double* even,
                                              const double* odd, std::size_t count, double* low,
                                              double* high) {
  using Lanes = Register<kLanes>;
  constexpr std::size_t kParts = kKernelStep / kLanes;
  const FilterPair::Taps* const taps = filters.taps.data();
  const std::size_t phases = filters.taps.size();
  for (std::size_t k = 0; k < count; k += kKernelStep) {
    typename Lanes::Type low_sum[kParts] = {};
    typename Lanes::Type high_sum[kParts] = {};
    for (std::size_t i = 0; i < phases; ++i) {
      const FilterPair::Taps tap = taps[i];
      const std::size_t at = k + phases - 1 - i;
      for (std::size_t p = 0; p < kParts; ++p) {
        const typename Lanes::Type& odds = Lanes::at(odd + at + p * kLanes);
        const typename Lanes::Type& evens = Lanes::at(even + at + p * kLanes);
        low_sum[p] += tap.low_even * odds;
        low_sum[p] += tap.low_odd * evens;
        high_sum[p] += tap.high_even * odds;
        high_sum[p] += tap.high_odd * evens;
      }
    }
    for (std::size_t p = 0; p < kParts; ++p) {
      Lanes::at(low + k + p * kLanes) = low_sum[p];
      Lanes::at(high + k + p * kLanes) = high_sum[p];
    }
  }
}

template <std::size_t kLanes>
[[gnu::always_inline]] inline void synthesise_by(const FilterPair& filters, const double* low,
                                                 const double* high, std::size_t count,
                                                 double* even, double* odd) {
  using Lanes = Register<kLanes>;
  constexpr std::size_t kParts = kKernelStep / kLanes;
  const FilterPair::Taps* const taps = filters.taps.data();
  const std::size_t phases = filters.taps.size();
  for (std::size_t k = 0; k < count; k += kKernelStep) {
    typename Lanes::Type even_sum[kParts] = {};
    typename Lanes::Type odd_sum[kParts] = {};
    for (std::size_t i = 0; i < phases; ++i) {
      const FilterPair::Taps tap = taps[i];
      for (std::size_t p = 0; p < kParts; ++p) {
        const typename Lanes::Type& lows = Lanes::at(low + k + i + p * kLanes);
        const typename Lanes::Type& highs = Lanes::at(high + k + i + p * kLanes);
        even_sum[p] += tap.low_odd * lows;
        even_sum[p] += tap.high_odd * highs;
        odd_sum[p] += tap.low_even * lows;
        odd_sum[p] += tap.high_even * highs;
      }
    }
    for (std::size_t p = 0; p < kParts; ++p) {
      Lanes::at(even + k + p * kLanes) = even_sum[p];
      Lanes::at(odd + k + p * kLanes) = odd_sum[p];
    }
  }
}

// Compiled for any processor and for AVX2. That has no fused multiply-add, so both give the same
// bits.
#ifdef __x86_64__
[[gnu::target("avx2")]] void analyse_by_avx2(const FilterPair& filters, const double* even,
                                             const double* odd, std::size_t count, double* low,
                                             double* high) {
  analyse_by<4>(filters, even, odd, count, low, high);
}
[[gnu::target("avx2")]] void synthesise_by_avx2(const FilterPair& filters, const double* low,
                                                const double* high, std::size_t count, double* even,
                                                double* odd) {
  synthesise_by<4>(filters, low, high, count, even, odd);
}
const bool kHasAvx2 = __builtin_cpu_supports("avx2") != 0;
const auto kAnalyse = kHasAvx2 ? analyse_by_avx2 : analyse_by<2>;
const auto kSynthesise = kHasAvx2 ? synthesise_by_avx2 : synthesise_by<2>;
#else
const auto kAnalyse = analyse_by<2>;
const auto kSynthesise = synthesise_by<2>;
#endif

}  // namespace

void analyse(const FilterPair& filters, const double* even, const double* odd, std::size_t count,
             double* low, double* high) {
  kAnalyse(filters, even, odd, count, low, high);
}

void synthesise(const FilterPair& filters, const double* low, const double* high, std::size_t count,
                double* even, double* odd) {
  kSynthesise(filters, low, high, count, even, odd);
}

FilterPair::FilterPair(const std::vector<double>& lowpass) {
  const std::vector<double> highpass = highpass_filter(lowpass);
  for (std::size_t i = 0; i < lowpass.size(); i += 2) {
    taps.push_back({lowpass[i], lowpass[i + 1], highpass[i], highpass[i + 1]});
  }
}

}  // namespace fogcomp::denoise
