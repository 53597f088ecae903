#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fog::hal {

/// The slots of loaded models: word aligned, in flash, at least one sector each.
struct ModelMemory {
  const std::int32_t* words;
  std::size_t size;  ///< words
};

std::array<ModelMemory, 2> model_memories();

// Erasing and programming take time, in which the processor may stop, and with it samples, requests
// and milliseconds; both inform the watchdog. They return false if the flash reports a failure. The
// caller reads the contents back.

/// Sets all words of a slot to -1. Takes up to 2.4 s, for which it extends the watchdog: the caller
/// starts it again.
bool erase_model_memory(std::size_t slot);

/// Writes `count` erased words of a slot, from word `at` on. Takes up to 0.4 ms per word.
bool program_model_memory(std::size_t slot, std::size_t at, const std::uint32_t* words,
                          std::size_t count);

}  // namespace fog::hal
