#include "platform/shared/linker_symbols.hpp"

namespace fog::platform {

/// First in the image, where the machine begins: gives start-up its stack.
extern "C" [[gnu::naked, gnu::section(".vectors"), gnu::used]] void fog_entry() {
  asm volatile(
      "la sp, fog_stack_top\n"
      "j fog_reset_handler\n");
}

}  // namespace fog::platform
