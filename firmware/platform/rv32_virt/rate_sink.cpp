#include "hal/rate_sink.hpp"

#include "platform/rv32_virt/peripherals.hpp"
#include "platform/shared/semihosting.hpp"

namespace fog::hal {
namespace {

// The line is as slow as whoever reads it, so only a reader that is gone ends the wait.
constexpr std::uint32_t kTransmitPolls = 1'000'000;

void send_byte(platform::ByteUart& uart, std::uint8_t byte) {
  for (std::uint32_t polls = 0; polls < kTransmitPolls; ++polls) {
    if ((uart.line_status & platform::ByteUart::kTransmitEmpty) != 0) break;
  }
  uart.data = byte;
}

}  // namespace

void write_output_stream(const std::uint8_t* bytes, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) send_byte(platform::line_uart(), bytes[i]);
}

// The machine has one UART, whose two directions are the sensor and the output stream.
void write_console(const char* text) {
  platform::semihosting::write_text(text);
}

}  // namespace fog::hal
