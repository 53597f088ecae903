#include "hal/model_memory.hpp"
#include "platform/cortex_m/memory_protection.hpp"

// Memory that behaves like flash: writing clears bits, only erasing sets them.
namespace fog::hal {
namespace {

std::int32_t* words_of(std::size_t slot) {
  return const_cast<std::int32_t*>(model_memories()[slot].words);
}

}  // namespace

bool erase_model_memory(std::size_t slot) {
  std::int32_t* const memory = words_of(slot);
  platform::allow_writes(memory, true);
  for (std::size_t i = 0; i < model_memories()[slot].size; ++i) memory[i] = -1;
  platform::allow_writes(memory, false);
  return true;
}

bool program_model_memory(std::size_t slot, std::size_t at, const std::uint32_t* words,
                          std::size_t count) {
  std::int32_t* const memory = words_of(slot);
  platform::allow_writes(memory, true);
  for (std::size_t i = 0; i < count; ++i) memory[at + i] &= static_cast<std::int32_t>(words[i]);
  platform::allow_writes(memory, false);
  return true;
}

}  // namespace fog::hal
