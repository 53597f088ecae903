#include "platform/shared/processor.hpp"

#include <cstdint>

#include "hal/interrupts.hpp"
#include "platform/cortex_m/memory_protection.hpp"
#include "platform/cortex_m/system_control.hpp"
#include "platform/shared/linker_symbols.hpp"

namespace fog::platform {

void prepare_processor() {
  SystemControlBlock& control = system_control_block();
  // The reset value 0 works only if flash is mirrored there, which a boot loader may have changed.
  control.vector_table_offset.write(reinterpret_cast<std::uintptr_t>(fog_image_start));
  control.configuration.set(SystemControlBlock::kTrapDivisionByZero);
  protect_memory();
  disable_all_interrupts();
  hal::release_interrupts();
}

void reset_processor() {
  asm volatile("dsb" ::: "memory");
  system_control_block().application_interrupt_and_reset.write(
      SystemControlBlock::kResetKeyAndRequest);
  asm volatile("dsb" ::: "memory");
  for (;;) {  // the reset takes a few cycles to arrive
  }
}

}  // namespace fog::platform
