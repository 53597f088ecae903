#include "platform/cortex_m/vector_table.hpp"
#include "platform/ports.hpp"
#include "platform/stm32f405/peripherals.hpp"

namespace fog::platform {
namespace {

constexpr InterruptHandler kHandlers[] = {{kUsart1Interrupt, on_request_interrupt},
                                          {kUsart2Interrupt, on_sensor_interrupt}};

[[gnu::section(".vectors"), gnu::used]] constexpr auto kVectors =
    make_vector_table<kInterruptLines>(kHandlers);

}  // namespace
}  // namespace fog::platform
