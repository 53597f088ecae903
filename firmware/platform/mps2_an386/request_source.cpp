#include "hal/request_source.hpp"

#include "platform/cortex_m/event.hpp"
#include "platform/cortex_m/system_control.hpp"
#include "platform/mps2_an386/peripherals.hpp"
#include "platform/ports.hpp"
#include "platform/ring_buffer.hpp"

namespace fog {
namespace platform {
namespace {

RingBuffer<FOG_REQUEST_BYTES> requested;

}  // namespace

void open_request_port() {
  output_uart().control.set(CmsdkUart::kReceiver | CmsdkUart::kReceiveInterrupt);
  enable_interrupt(kRequestInterrupt);
}

// The interrupt is cleared before the byte is read: later it would clear that of the next byte.
void on_request_interrupt() {
  output_uart().interrupt.write(CmsdkUart::kReceived);
  requested.push(static_cast<std::uint8_t>(output_uart().data.read()));
  signal_event();
}

}  // namespace platform

std::size_t hal::read_requests(std::uint8_t* destination, std::size_t capacity) {
  return platform::requested.pop(destination, capacity);
}

}  // namespace fog
