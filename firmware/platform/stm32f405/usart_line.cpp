#include "platform/stm32f405/usart_line.hpp"

namespace fog::platform {
namespace {

constexpr std::uint32_t kAlternateFunctionMode = 2;
constexpr std::uint32_t kPullUp = 1;  // an unconnected line is an idle line, not noise

// A byte at 115200 baud lasts 14,600 cycles of 168 MHz. Where the USART never gets ready (no clock
// yet, because start-up trapped) the byte is given up rather than the report.
constexpr std::uint32_t kTransmitPolls = 20'000;

void connect(const Pin& pin) {
  const auto port = static_cast<std::uint32_t>(pin.port);
  const std::uint32_t number = pin.number;
  enable_clock(rcc().ahb1_enable, 1U << port);
  const std::uint32_t shift = 4U * (number % 8U);
  gpio(port).alternate_function[number / 8U].replace(
      0xFU << shift, std::uint32_t{pin.alternate_function} << shift);
  gpio(port).pull.replace(3U << (2U * number), kPullUp << (2U * number));
  gpio(port).mode.replace(3U << (2U * number), kAlternateFunctionMode << (2U * number));
}

}  // namespace

void open_line(Usart& usart, const Pin& pin, std::uint32_t control, std::uint32_t bus_hz,
               std::uint32_t baud) {
  connect(pin);
  usart.baud_rate.write((bus_hz + baud / 2U) / baud);
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
