#include "platform/cortex_m/stack.hpp"

#include <cstdint>

#include "platform/cortex_m/linker_symbols.hpp"

namespace fog::platform {
namespace {

// Not zero, not a small number, not an address: nothing the firmware is likely to push.
constexpr std::uint32_t kPaint = 0xC5C5C5C5U;

}  // namespace

void paint_stack() {
  const std::uint32_t* stack_pointer;
  asm volatile("mov %0, sp" : "=r"(stack_pointer));
  for (volatile std::uint32_t* word = fog_stack_bottom; word < stack_pointer; ++word) {
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
