#include "hal/rate_sink.hpp"

#include "platform/line_rates.hpp"
#include "platform/ports.hpp"
#include "platform/stm32f405/clock_tree.hpp"
#include "platform/stm32f405/usart_line.hpp"

// The console. How the output stream leaves is chosen when building: output_polled or output_dma.
namespace fog {

void platform::open_console_port() {
  enable_clock(rcc().apb1_enable, Rcc::kUsart3);
  open_line(usart3(), kConsoleTx, Usart::kTransmitter, clock_tree().apb1_hz, kConsoleBaud);
}

void hal::write_console(const char* text) {
  for (; *text != '\0'; ++text) {
    platform::send_byte(platform::usart3(), static_cast<std::uint8_t>(*text));
  }
}

}  // namespace fog
