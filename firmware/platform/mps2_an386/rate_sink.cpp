#include "hal/rate_sink.hpp"

#include "platform/line_rates.hpp"
#include "platform/mps2_an386/peripherals.hpp"
#include "platform/ports.hpp"

namespace fog {
namespace platform {
namespace {

// A byte at 115200 baud takes 2,200 cycles of 25 MHz. In the emulator the line is as slow as its
// reader, so the bound is that of the watchdog, 100 ms.
constexpr std::uint32_t kTransmitPolls = 500'000;

// This UART has neither parity nor a second stop bit.
void open(CmsdkUart& uart, SerialLine line) {
  uart.baud_divisor.write(kClockHz / line.baud());
  uart.control.write(CmsdkUart::kTransmitter);
}

void send_byte(CmsdkUart& uart, std::uint8_t byte) {
  wait_for_bits(uart.state, CmsdkUart::kTransmitFull, 0, kTransmitPolls);
  uart.data.write(byte);
}

}  // namespace

void open_output_port(SerialLine line) {
  open(output_uart(), line);
}
void open_console_port() {
  open(console_uart(), SerialLine(kConsoleBaud));
}

}  // namespace platform

namespace hal {

void write_output_stream(const std::uint8_t* bytes, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) platform::send_byte(platform::output_uart(), bytes[i]);
}

void write_console(const char* text) {
  for (; *text != '\0'; ++text) {
    platform::send_byte(platform::console_uart(), static_cast<std::uint8_t>(*text));
  }
}

}  // namespace hal
}  // namespace fog
