#include <cstdint>

#include "hal/interrupts.hpp"
#include "platform/board.hpp"
#include "platform/shared/linker_symbols.hpp"
#include "platform/shared/processor.hpp"
#include "platform/shared/stack.hpp"

namespace fog::platform {
namespace {

void initialise_memory() {
  const std::uint32_t* from = fog_data_load;
  for (std::uint32_t* to = fog_data_start; to < fog_data_end;) *to++ = *from++;
  for (std::uint32_t* to = fog_bss_start; to < fog_bss_end;) *to++ = 0;
}

}  // namespace

// No static constructors: every object at namespace scope is constant-initialised, so there is no
// order of initialisation. The linker refuses an image that needs one.
extern "C" [[noreturn]] void fog_reset_handler() {
  hal::hold_interrupts();  // a boot loader may have left some enabled, whose handlers need memory
  paint_stack();
  initialise_memory();
  prepare_processor();
  app::run();
}

}  // namespace fog::platform
