#include "platform/stm32f405/usart_line.hpp"

#include "platform/stm32f405/pin_modes.hpp"

namespace fog::platform {
namespace {

// A byte at 115200 baud takes 87 us, a poll at least 5 cycles: 0.6 ms of polls at any clock.
std::uint32_t transmit_polls() {
  return clock_tree().core_hz / 8192U;
}

// USART that did not become ready in that time: it is not waited for again, because the frames of
// one loop would take longer than the watchdog allows.
const Usart* stuck = nullptr;

}  // namespace

void open_line(Usart& usart, const Pin& pin, std::uint32_t control, std::uint32_t bus_hz,
               std::uint32_t baud) {
  connect(pin);
  usart.baud_rate.write(baud_divisor(bus_hz, baud));
  usart.control1.write(Usart::kEnable | control);
}

void open_receiver(Usart& usart, const Pin& pin) {
  connect(pin);
  usart.control1.set(Usart::kReceiver | Usart::kReceiveInterrupt);
}

void send_byte(Usart& usart, std::uint8_t byte) {
  const std::uint32_t polls = stuck == &usart ? 0 : transmit_polls();
  if (wait_for_bits(usart.status, Usart::kTransmitReady, Usart::kTransmitReady, polls)) {
    stuck = nullptr;
    usart.data.write(byte);
  } else {
    stuck = &usart;
  }
}

}  // namespace fog::platform
