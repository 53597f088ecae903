#include "hal/rate_sink.hpp"

#include "platform/line_rates.hpp"
#include "platform/ports.hpp"
#include "platform/stm32f405/usart_line.hpp"
#include "wiring.hpp"

// The console. The build selects the output stream's driver: output_polled or output_dma.
namespace fog {

void platform::open_console_port() {
  open_line(kConsoleUsart, kConsoleTx, Usart::kTransmitter, SerialLine(kConsoleBaud));
}

void hal::write_console(const char* text) {
  for (; *text != '\0'; ++text) {
    platform::send_byte(registers(platform::kConsoleUsart), static_cast<std::uint8_t>(*text));
  }
}

}  // namespace fog
