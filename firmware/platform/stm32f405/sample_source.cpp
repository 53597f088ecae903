#include "hal/sample_source.hpp"

#include "platform/cortex_m/event.hpp"
#include "platform/cortex_m/system_control.hpp"
#include "platform/ports.hpp"
#include "platform/ring_buffer.hpp"
#include "platform/stm32f405/usart_line.hpp"
#include "platform/stm32f405/validity_pin.hpp"
#include "wiring.hpp"

namespace fog {
namespace platform {
namespace {

// 11 ms of continuous data at 921600 baud; a third of a second at 200 samples per second.
RingBuffer<1024> received;

}  // namespace

void open_sensor_port(SerialLine line) {
  if constexpr (kHasValidityPin) open_validity_pin();
  constexpr std::uint32_t kIdleInterrupt = kHasValidityPin ? Usart::kIdleInterrupt : 0;
  open_line(kSensorUsart, kSensorRx, Usart::kReceiver | Usart::kReceiveInterrupt | kIdleInterrupt,
            line);
  enable_interrupt(kSensorUsart.interrupt);
}

// Reading status, then data, also clears an idle line, and an overrun, which would otherwise
// interrupt repeatedly; the data register holds the last good byte, lost bytes show in the stream.
// If the buffer is full, the byte stays in the USART and the interrupt is disabled until the reader
// enables it again.
void on_sensor_interrupt() {
  if (received.is_full()) {
    disable_interrupt(kSensorUsart.interrupt);
    return;
  }
  const std::uint32_t status = registers(kSensorUsart).status.read();
  const bool has_byte = (status & Usart::kReceived) != 0;
  const auto byte = static_cast<std::uint8_t>(registers(kSensorUsart).data.read());
  if (has_byte) received.push(byte);
  if constexpr (kHasValidityPin) {
    if (has_byte) start_of_sample();
    if ((status & Usart::kIdle) != 0) end_of_sample();
  }
  signal_event();
}

}  // namespace platform

namespace hal {

std::size_t read_sensor_stream(std::uint8_t* destination, std::size_t capacity) {
  const std::size_t count = platform::received.pop(destination, capacity);
  if (count > 0) platform::enable_interrupt(platform::kSensorUsart.interrupt);
  return count;
}

}  // namespace hal
}  // namespace fog
