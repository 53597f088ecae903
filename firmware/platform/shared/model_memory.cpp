#include "hal/model_memory.hpp"

#include "platform/shared/linker_symbols.hpp"

namespace fog::hal {

std::array<ModelMemory, 2> model_memories() {
  constexpr std::size_t kWords = 4096;  // 16 KiB
  return {{{fog_model_slot_0, kWords}, {fog_model_slot_1, kWords}}};
}

}  // namespace fog::hal
