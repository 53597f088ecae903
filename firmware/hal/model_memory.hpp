#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fog::hal {

/// Where models lie that are loaded into a board: word aligned, in flash, a sector or more each.
struct ModelMemory {
  const std::int32_t* words;
  std::size_t size;  ///< words
};

std::array<ModelMemory, 2> model_memories();

// What follows takes a flash its time, in which the processor may stand still, and with it samples
// and requests; then milliseconds stand still as well, and the watchdog is told. Both end, and
// return false where the flash says that it has failed. What it holds is for the caller to read
// back.

/// All words of a slot are -1 afterwards. Up to 2.4 s.
bool erase_model_memory(std::size_t slot);

/// Writes `count` words of a slot, from word `at` on, that are erased. Up to 0.4 ms a word.
bool program_model_memory(std::size_t slot, std::size_t at, const std::uint32_t* words,
                          std::size_t count);

}  // namespace fog::hal
