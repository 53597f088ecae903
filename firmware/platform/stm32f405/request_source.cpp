#include "hal/request_source.hpp"

#include "platform/cortex_m/event.hpp"
#include "platform/cortex_m/system_control.hpp"
#include "platform/ports.hpp"
#include "platform/ring_buffer.hpp"
#include "platform/stm32f405/usart_line.hpp"
#include "wiring.hpp"

namespace fog {
namespace platform {
namespace {

RingBuffer<FOG_REQUEST_BYTES> requested;

}  // namespace

void open_request_port() {
  open_receiver(registers(kOutputUsart), kRequestRx);
  enable_interrupt(kOutputUsart.interrupt);
}

// Reading status, then data, also clears an overrun, which would otherwise interrupt repeatedly.
void on_request_interrupt() {
  const bool has_byte = registers(kOutputUsart).status.any(Usart::kReceived);
  const auto byte = static_cast<std::uint8_t>(registers(kOutputUsart).data.read());
  if (has_byte) requested.push(byte);
  signal_event();
}

}  // namespace platform

std::size_t hal::read_requests(std::uint8_t* destination, std::size_t capacity) {
  return platform::requested.pop(destination, capacity);
}

}  // namespace fog
