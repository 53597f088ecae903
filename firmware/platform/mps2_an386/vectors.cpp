#include "platform/cortex_m/nmi.hpp"
#include "platform/cortex_m/vector_table.hpp"
#include "platform/mps2_an386/peripherals.hpp"
#include "platform/ports.hpp"

namespace fog::platform {

const hal::ResetCause kNmiCause = hal::ResetCause::watchdog;

namespace {

constexpr InterruptHandler kHandlers[] = {{kRequestInterrupt, on_request_interrupt},
                                          {kSensorInterrupt, on_sensor_interrupt}};

[[gnu::section(".vectors"), gnu::used]] constexpr auto kVectors =
    make_vector_table<kInterruptLines>(kHandlers);

}  // namespace
}  // namespace fog::platform
