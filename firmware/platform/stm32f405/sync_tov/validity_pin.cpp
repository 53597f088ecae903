#include "platform/stm32f405/validity_pin.hpp"

#include "platform/stm32f405/peripherals.hpp"
#include "wiring.hpp"

// The receiver itself notes that the line has been idle for the time of one byte. So the edge comes
// this time after the sample, whatever the processor does, but for the way into the interrupt.
namespace fog::platform {
namespace {

constexpr auto kPort = static_cast<std::uint32_t>(kTimeOfValidity.port);
constexpr std::uint32_t kHigh = 1U << kTimeOfValidity.number;
constexpr std::uint32_t kLow = kHigh << 16U;

}  // namespace

void open_validity_pin() {
  constexpr std::uint32_t kShift = 2U * kTimeOfValidity.number;
  enable_clock(rcc().ahb1_enable, Rcc::kGpioA << kPort);
  gpio(kPort).set_reset.write(kLow);
  gpio(kPort).mode.replace(3U << kShift, Gpio::kOutput << kShift);
}

void start_of_sample() {
  gpio(kPort).set_reset.write(kLow);
}

void end_of_sample() {
  gpio(kPort).set_reset.write(kHigh);
}

}  // namespace fog::platform
