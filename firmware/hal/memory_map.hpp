#pragma once

#include <cstdint>

namespace fog::hal {

/// Memories that the built-in tests check, as the linker placed them; whole words.
struct MemoryMap {
  const std::uint8_t* image_start;  ///< in flash: vector table to seal
  const std::uint8_t* image_end;
  std::uint32_t* ram_start;  ///< all that is in use: stack, variables, what outlives a restart; not
                             ///< what a DMA uses
  std::uint32_t* ram_end;
  std::uint32_t* stack_top;  ///< within the RAM; the stack grows down from it
};

MemoryMap memory_map();

}  // namespace fog::hal
