#include <cstdint>

#include "platform/board.hpp"
#include "platform/cortex_m/linker_symbols.hpp"
#include "platform/cortex_m/stack.hpp"
#include "platform/cortex_m/system_control.hpp"
#include "platform/cortex_m/vector_table.hpp"

namespace fog::platform {
namespace {

void initialise_memory() {
  const std::uint32_t* from = fog_data_load;
  for (std::uint32_t* to = fog_data_start; to < fog_data_end;) *to++ = *from++;
  for (std::uint32_t* to = fog_bss_start; to < fog_bss_end;) *to++ = 0;
}

}  // namespace

// No static constructors run here: every object at namespace scope is constant-initialised, so
// there is no order to get wrong and nothing to pay for. The linker refuses an image that needs
// one.
void fog_reset_handler() {
  paint_stack();
  initialise_memory();
  SystemControlBlock& control = system_control_block();
  // The reset value 0 works only where the flash is mirrored there, not behind a boot loader.
  control.vector_table_offset.write(reinterpret_cast<std::uintptr_t>(fog_image_start));
  control.configuration.set(SystemControlBlock::kTrapDivisionByZero);
  app::run();
}

}  // namespace fog::platform
