#include "hal/sample_source.hpp"

#include "platform/cortex_m/event.hpp"
#include "platform/cortex_m/system_control.hpp"
#include "platform/line_rates.hpp"
#include "platform/ports.hpp"
#include "platform/ring_buffer.hpp"
#include "platform/stm32f405/usart_line.hpp"
#include "wiring.hpp"

namespace fog {
namespace platform {
namespace {

// 11 ms of an uninterrupted line at 921600 baud; at 200 samples a second, a third of a second.
RingBuffer<1024> received;

}  // namespace

void open_sensor_port() {
  open_line(kSensorUsart, kSensorRx, Usart::kReceiver | Usart::kReceiveInterrupt, kSensorBaud);
  enable_interrupt(kSensorUsart.interrupt);
}

// Reading status, then data, also clears an overrun, which would otherwise interrupt for ever; the
// byte in the data register is the last good one, the lost ones show in the stream. While the
// buffer is full the byte stays in the USART and the line is not served: the reader opens it again.
void on_sensor_interrupt() {
  if (received.is_full()) {
    disable_interrupt(kSensorUsart.interrupt);
    return;
  }
  const bool has_byte = registers(kSensorUsart).status.any(Usart::kReceived);
  const auto byte = static_cast<std::uint8_t>(registers(kSensorUsart).data.read());
  if (has_byte) received.push(byte);
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
