#pragma once

#include <cstddef>
#include <cstdint>

// Loops over packs of doubles that are written once and compiled for each kind of register. What
// works on packs is forced inline: how a register would be passed between functions is nobody's
// ABI, and the caller's target is what it is compiled for.
#pragma GCC diagnostic ignored "-Wpsabi"
#define FOGCOMP_INLINE [[gnu::always_inline]] inline

namespace fogcomp {

/// The registers of a processor: doubles, 64-bit integers of the same width, and doubles in memory
/// at any address.
struct Sse2 {
  using Pack = double __attribute__((vector_size(16)));
  using Bits = std::int64_t __attribute__((vector_size(16)));
  using InMemory = double __attribute__((vector_size(16), aligned(8), may_alias));
};
struct Avx2 {
  using Pack = double __attribute__((vector_size(32)));
  using Bits = std::int64_t __attribute__((vector_size(32)));
  using InMemory = double __attribute__((vector_size(32), aligned(8), may_alias));
};

template <class R>
constexpr std::size_t kLanes = sizeof(typename R::Pack) / sizeof(double);

template <class R>
FOGCOMP_INLINE typename R::Pack load(const double* from) {
  return *reinterpret_cast<const typename R::InMemory*>(from);
}
template <class R>
FOGCOMP_INLINE void store(double* to, typename R::Pack pack) {
  *reinterpret_cast<typename R::InMemory*>(to) = pack;
}

/// Of the processor that this runs on.
inline bool has_avx2() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

}  // namespace fogcomp
