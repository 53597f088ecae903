#include "platform/shared/linker_symbols.hpp"

namespace fog::platform {

/// First code of the image, where the machine starts: sets the stack pointer.
extern "C" [[gnu::naked, gnu::section(".vectors"), gnu::used]] void fog_entry() {
  asm volatile(
      "la sp, fog_stack_top\n"
      "j fog_reset_handler\n");
}

}  // namespace fog::platform
