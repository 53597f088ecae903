#include "hal/memory_map.hpp"

#include "platform/shared/linker_symbols.hpp"

namespace fog::hal {

MemoryMap memory_map() {
  return {fog_image_start, fog_image_end, fog_stack_bottom, fog_ram_end, fog_stack_top};
}

}  // namespace fog::hal
