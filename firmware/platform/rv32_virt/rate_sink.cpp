#include "hal/rate_sink.hpp"

#include "platform/rv32_virt/peripherals.hpp"

namespace fog::hal {

// The emulated UART accepts a byte at any time. It is the only one: the output stream of the bulk
// image goes to a file.
void write_console(const char* text) {
  for (; *text != '\0'; ++text) {
    platform::console_uart().data = static_cast<std::uint8_t>(*text);
  }
}

}  // namespace fog::hal
