#include "hal/rate_sink.hpp"

#include "platform/line_rates.hpp"
#include "platform/ports.hpp"
#include "platform/stm32f405/clock_tree.hpp"
#include "platform/stm32f405/usart_line.hpp"

namespace fog {
namespace platform {

void open_output_port() {
  enable_clock(rcc().apb2_enable, Rcc::kUsart1);
  open_line(usart1(), kOutputTx, Usart::kTransmitter, clock_tree().apb2_hz, kOutputBaud);
}

void open_console_port() {
  enable_clock(rcc().apb1_enable, Rcc::kUsart3);
  open_line(usart3(), kConsoleTx, Usart::kTransmitter, clock_tree().apb1_hz, kConsoleBaud);
}

}  // namespace platform

namespace hal {

void write_output_stream(const std::uint8_t* bytes, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) platform::send_byte(platform::usart1(), bytes[i]);
}

void write_console(const char* text) {
  for (; *text != '\0'; ++text) {
    platform::send_byte(platform::usart3(), static_cast<std::uint8_t>(*text));
  }
}

}  // namespace hal
}  // namespace fog
