#include "hal/clock.hpp"

#include "platform/cortex_m/event.hpp"
#include "platform/cortex_m/system_control.hpp"
#include "platform/cortex_m/tick.hpp"
#include "platform/cortex_m/vector_table.hpp"

namespace fog {
namespace platform {
namespace {

volatile std::uint32_t elapsed_ms = 0;

}  // namespace

void start_tick(std::uint32_t core_clock_hz) {
  systick().reload.write(core_clock_hz / 1000U - 1U);
  systick().current.write(0);
  systick().control.write(SysTick::kProcessorClock | SysTick::kInterrupt | SysTick::kEnable);
}

void fog_tick_handler() {
  elapsed_ms = elapsed_ms + 1;
  signal_event();
}

}  // namespace platform

namespace hal {

std::uint32_t milliseconds() {
  return platform::elapsed_ms;
}

}  // namespace hal
}  // namespace fog
