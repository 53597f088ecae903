#include "platform/board.hpp"

#include "hal/clock.hpp"
#include "hal/model_memory.hpp"
#include "hal/processor.hpp"
#include "hal/request_source.hpp"
#include "hal/service_strap.hpp"
#include "hal/watchdog.hpp"
#include "platform/ports.hpp"
#include "platform/rv32/tick.hpp"
#include "platform/rv32_virt/peripherals.hpp"
#include "platform/shared/processor.hpp"
#include "platform/shared/restart.hpp"

// What the machine lacks. It is a second instruction set, no board: nobody flies it.
namespace fog::hal {

// Its serial line is as fast as whoever writes to it.
bool clock_is_accurate() {
  return false;
}
bool clock_keeps_time() {
  return false;
}
void try_another_speed() {}

ProcessorNumber processor_number() {
  return {};
}

void start_watchdog(std::uint32_t) {}
void extend_watchdog(std::uint32_t) {}
void kick_watchdog() {}

// Its one line back is the sensor's: no requests, so no table is ever loaded.
std::size_t read_requests(std::uint8_t*, std::size_t) {
  return 0;
}
bool service_strap_closed() {
  return false;
}
bool erase_model_memory(std::size_t) {
  return false;
}
bool program_model_memory(std::size_t, std::size_t, const std::uint32_t*, std::size_t) {
  return false;
}

}  // namespace fog::hal

namespace fog::platform {

MachineTimer machine_timer() {
  constexpr std::uint32_t kHz = 10'000'000;
  return {&peripheral_at<TimerCount>(0x0200BFF8U), &peripheral_at<TimerCount>(0x02004000U), kHz};
}

// This machine keeps no record of resets: only the firmware's own restarts are known.
void start_board() {
  report_reset(hal::ResetCause::unknown);
  start_tick();
}

void open_lines(SerialLine sensor, SerialLine /*output*/) {
  open_sensor_port(sensor);
}

BoardDescription describe_board() {
  return {"rv32_virt", 0, "the emulator", false, true};
}

void restart_board() {
  restart(hal::ResetCause::self_test);
}

void restart_on_request() {
  restart(hal::ResetCause::software);
}

void reset_processor() {
  test_device().command.write(TestDevice::kRestart);
  for (;;) {
  }
}

}  // namespace fog::platform
