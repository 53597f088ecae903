#include "platform/stm32f405/usart_line.hpp"

#include "platform/stm32f405/pin_modes.hpp"

namespace fog::platform {
namespace {

// A byte at 115200 baud lasts 14,600 cycles of 168 MHz. A USART that never gets ready costs the
// byte, not the board.
constexpr std::uint32_t kTransmitPolls = 20'000;

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
  wait_for_bits(usart.status, Usart::kTransmitReady, Usart::kTransmitReady, kTransmitPolls);
  usart.data.write(byte);
}

}  // namespace fog::platform
