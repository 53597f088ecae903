#include "support/large_array.hpp"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace fogcomp {
namespace {

constexpr std::size_t kHugePageBytes = std::size_t{2} << 20U;
constexpr std::size_t kCacheLineBytes = 64;

}  // namespace

LargeArray::LargeArray(std::size_t size) : size_(size) {
  const std::size_t bytes = size * sizeof(double);
  const bool huge = bytes >= 2 * kHugePageBytes;
  const std::size_t alignment = huge ? kHugePageBytes : kCacheLineBytes;
  void* memory = std::aligned_alloc(alignment, (bytes + alignment) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
#if defined(MADV_HUGEPAGE)
  // A wish: without it, or refused, everything is the same but slower.
  if (huge) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
  values_.reset(static_cast<double*>(memory));
}

void LargeArray::Free::operator()(double* values) const {
  std::free(values);
}

}  // namespace fogcomp
