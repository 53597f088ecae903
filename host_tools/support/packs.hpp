#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

// Loops over packs of doubles that are written once and compiled for each kind of register. What
// works on packs is forced inline: how a register would be passed between functions is nobody's
// ABI, and the caller's target is what it is compiled for.
#pragma GCC diagnostic ignored "-Wpsabi"
#define FOGCOMP_INLINE [[gnu::always_inline]] inline

namespace fogcomp {

/// The registers of a processor: doubles, and 64-bit integers of the same width.
struct Sse2 {
  using Pack = double __attribute__((vector_size(16)));
  using Bits = std::int64_t __attribute__((vector_size(16)));
};
struct Avx2 {
  using Pack = double __attribute__((vector_size(32)));
  using Bits = std::int64_t __attribute__((vector_size(32)));
};

template <class R>
constexpr std::size_t kLanes = sizeof(typename R::Pack) / sizeof(double);

// Copying is how C++ says "at any address"; it becomes one unaligned move.
template <class R>
FOGCOMP_INLINE typename R::Pack load(const double* from) {
  typename R::Pack pack;
  std::memcpy(&pack, from, sizeof pack);
  return pack;
}
template <class R>
FOGCOMP_INLINE void store(double* to, typename R::Pack pack) {
  std::memcpy(to, &pack, sizeof pack);
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
