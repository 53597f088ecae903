// Blocks of megabytes lie on huge pages, where the system gives them on request. A recording's
// columns are written once: to touch their pages of 4 KB one by one takes longer than to read the
// file.
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21;

void* allocate(std::size_t size) {
#ifdef MADV_HUGEPAGE
  if (size >= 2 * kHugePage) {
    void* const block =
        std::aligned_alloc(kHugePage, (size + kHugePage - 1) / kHugePage * kHugePage);
    // A wish: an error changes nothing.
    if (block != nullptr) ::madvise(block, size, MADV_HUGEPAGE);
    return block;
  }
#endif
  return std::malloc(size > 0 ? size : 1);
}

}  // namespace

void* operator new(std::size_t size) {
  for (;;) {
    if (void* const block = allocate(size)) return block;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}
void operator delete(void* block) noexcept {
  std::free(block);
}
void operator delete(void* block, std::size_t /*size*/) noexcept {
  std::free(block);
}
