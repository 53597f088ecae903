#include "hal/processor.hpp"

#include "platform/stm32f405/clock_tree.hpp"
#include "platform/stm32f405/peripherals.hpp"

// An emulator (its PLL never locks) lacks this memory: reading it would be a fault.
fog::hal::ProcessorNumber fog::hal::processor_number() {
  if (!platform::clock_tree().has_full_speed) return {};
  const auto& words = platform::unique_number().words;
  return {words[0].read(), words[1].read(), words[2].read()};
}
