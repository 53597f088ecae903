#include "platform/cortex_m/restart.hpp"

#include "platform/cortex_m/system_control.hpp"

namespace fog::platform {
namespace {

// After power-on the memory holds anything; a reason counts only beside its own complement.
struct RestartRecord {
  std::uint32_t reason;
  std::uint32_t complement;
};

[[gnu::noinit]] RestartRecord record;

}  // namespace

void restart(RestartReason reason) {
  record.reason = static_cast<std::uint32_t>(reason);
  record.complement = ~record.reason;
  asm volatile("dsb" ::: "memory");
  system_control_block().application_interrupt_and_reset.write(
      SystemControlBlock::kResetKeyAndRequest);
  asm volatile("dsb" ::: "memory");
  for (;;) {  // the reset takes a few cycles to arrive
  }
}

RestartReason take_restart_reason() {
  const RestartRecord found = record;
  record = {};
  if (found.reason != ~found.complement) return RestartReason::kNone;
  return static_cast<RestartReason>(found.reason);
}

}  // namespace fog::platform
