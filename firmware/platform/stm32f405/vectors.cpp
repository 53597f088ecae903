#include "platform/cortex_m/nmi.hpp"
#include "platform/cortex_m/vector_table.hpp"
#include "platform/ports.hpp"
#include "platform/stm32f405/peripherals.hpp"
#include "wiring.hpp"

namespace fog::platform {

// The clock security system (RM0090, 7.2.7).
const hal::ResetCause kNmiCause = hal::ResetCause::clock_failure;

namespace {

constexpr InterruptHandler kHandlers[] = {{kOutputUsart.interrupt, on_request_interrupt},
                                          {kSensorUsart.interrupt, on_sensor_interrupt}};

[[gnu::section(".vectors"), gnu::used]] constexpr auto kVectors =
    make_vector_table<kInterruptLines>(kHandlers);

}  // namespace
}  // namespace fog::platform
