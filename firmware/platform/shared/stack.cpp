#include "platform/shared/stack.hpp"

#include <cstdint>

#include "platform/shared/linker_symbols.hpp"

namespace fog::platform {
namespace {

// Neither zero nor a small number nor an address: unlikely to be pushed by the firmware.
constexpr std::uint32_t kPaint = 0xC5C5C5C5U;

// More than the frame of paint_stack(), less than the stack that anything after it uses.
constexpr std::uintptr_t kFrameBytes = 64;

}  // namespace

void paint_stack() {
  const volatile std::uint32_t here = 0;  // in this function's frame, which must stay intact
  const std::uintptr_t end = reinterpret_cast<std::uintptr_t>(&here) - kFrameBytes;
  for (volatile std::uint32_t* word = fog_stack_bottom;
       reinterpret_cast<std::uintptr_t>(word) < end; ++word) {
    *word = kPaint;
  }
}

std::size_t stack_bytes_reserved() {
  return static_cast<std::size_t>(fog_stack_top - fog_stack_bottom) * sizeof(std::uint32_t);
}

std::size_t stack_bytes_unused() {
  const std::uint32_t* word = fog_stack_bottom;
  while (word < fog_stack_top && *word == kPaint) ++word;
  return static_cast<std::size_t>(word - fog_stack_bottom) * sizeof(std::uint32_t);
}

}  // namespace fog::platform
