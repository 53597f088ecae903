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

}  // namespace fog::hal
