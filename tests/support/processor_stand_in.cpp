#include "support/processor_stand_in.hpp"

#include "hal/clock.hpp"
#include "platform/cortex_m/event.hpp"
#include "platform/cortex_m/memory_protection.hpp"

// The parts of the Cortex-M that drivers call, for this computer: a clock set by the test.
namespace fog {

std::uint32_t& test::now_ms() {
  static std::uint32_t time_ms = 0;
  return time_ms;
}

std::uint32_t hal::milliseconds() {
  return test::now_ms();
}

bool& test::writes_allowed() {
  static bool allowed = false;
  return allowed;
}

void platform::allow_writes(const void* /*start*/, bool allowed) {
  test::writes_allowed() = allowed;
}

void platform::signal_event() {}

}  // namespace fog
