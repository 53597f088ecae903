#include "hal/rate_sink.hpp"
#include "platform/ports.hpp"
#include "platform/stm32f405/usart_line.hpp"
#include "wiring.hpp"

// The core writes every byte itself: 64 bytes at 921600 baud take 0.7 ms of the 5 ms of a sample.
namespace fog {

void platform::open_output_port(SerialLine line) {
  open_line(kOutputUsart, kOutputTx, Usart::kTransmitter, line);
}

void hal::write_output_stream(const std::uint8_t* bytes, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i)
    platform::send_byte(registers(platform::kOutputUsart), bytes[i]);
}

}  // namespace fog
