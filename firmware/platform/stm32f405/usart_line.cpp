#include "platform/stm32f405/usart_line.hpp"

#include "platform/stm32f405/pin_modes.hpp"

namespace fog::platform {
namespace {

// A byte at 9600 baud takes up to 1.25 ms, a poll at least 5 cycles: 2.4 ms of polls at any clock.
std::uint32_t transmit_polls() {
  return clock_tree().core_hz / 2048U;
}

// USART that did not become ready in that time: it is not waited for again, because the frames of
// one loop would take longer than the watchdog allows.
const Usart* stuck = nullptr;

}  // namespace

void open_line(const UsartPort& port, const Pin& pin, std::uint32_t control, SerialLine line) {
  enable_clock(port);
  Usart& usart = registers(port);
  connect(pin);
  usart.baud_rate.write(baud_divisor(bus_hz(port), line.baud()));
  if constexpr (FOG_LINE_FORMATS != 0) {
    usart.control2.write(line.has_two_stop_bits() ? Usart::kTwoStopBits : 0U);
    if (line.has_parity()) control |= Usart::kParity | Usart::kNineBits;
    if (line.has_odd_parity()) control |= Usart::kOddParity;
  }
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
