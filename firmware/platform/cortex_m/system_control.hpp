#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "platform/shared/registers.hpp"

// The parts of the ARMv7-M System Control Space that this firmware uses (ARM DDI 0403, B3).
namespace fog::platform {

struct SysTick {
  Register control;
  Register reload;
  Register current;

  static constexpr std::uint32_t kEnable = 1U << 0U;
  static constexpr std::uint32_t kInterrupt = 1U << 1U;
  static constexpr std::uint32_t kProcessorClock = 1U << 2U;
};

struct SystemControlBlock {
  Register cpu_id;
  Register interrupt_control;
  Register vector_table_offset;
  Register application_interrupt_and_reset;
  Register system_control;
  Register configuration;
  std::array<Register, 3> system_handler_priority;
  Register system_handler_control;
  Register configurable_fault_status;
  Register hard_fault_status;
  Register debug_fault_status;
  Register memory_fault_address;
  Register bus_fault_address;

  static constexpr std::uint32_t kClearPendingTick = 1U << 25U;  // of interrupt_control
  static constexpr std::uint32_t kResetKeyAndRequest = (0x05FAU << 16U) | (1U << 2U);
  static constexpr std::uint32_t kTrapDivisionByZero = 1U << 4U;
  // configurable_fault_status: the address registers are valid
  static constexpr std::uint32_t kMemoryAddressValid = 1U << 7U;
  static constexpr std::uint32_t kBusAddressValid = 1U << 15U;
};
static_assert(offsetof(SystemControlBlock, configurable_fault_status) == 0x28 &&
              offsetof(SystemControlBlock, bus_fault_address) == 0x38);

/// B3.5.
struct MemoryProtectionUnit {
  Register type;
  Register control;
  Register region_number;
  Register region_base;
  Register region_attributes;

  // control, region_attributes
  static constexpr std::uint32_t kEnable = 1U << 0U;
  // control
  static constexpr std::uint32_t kDefaultMapElsewhere = 1U << 2U;
  // region_base: the number written beside the address selects the region
  static constexpr std::uint32_t kRegionValid = 1U << 4U;
  // region_attributes
  static constexpr std::uint32_t size_field(std::uint32_t log2_bytes) {
    return (log2_bytes - 1U) << 1U;
  }
  static constexpr std::uint32_t kNormalMemory = 1U << 17U;  // cacheable, written through
  static constexpr std::uint32_t kNoAccess = 0U << 24U;
  static constexpr std::uint32_t kReadWrite = 3U << 24U;
  static constexpr std::uint32_t kReadOnly = 6U << 24U;
  static constexpr std::uint32_t kExecuteNever = 1U << 28U;
};

struct InterruptController {
  std::array<Register, 32> set_enable;
  std::array<Register, 32> clear_enable;
  std::array<Register, 32> set_pending;
  std::array<Register, 32> clear_pending;
};

inline SysTick& systick() {
  return peripheral_at<SysTick>(0xE000E010U);
}
inline SystemControlBlock& system_control_block() {
  return peripheral_at<SystemControlBlock>(0xE000ED00U);
}
inline MemoryProtectionUnit& memory_protection_unit() {
  return peripheral_at<MemoryProtectionUnit>(0xE000ED90U);
}
inline InterruptController& interrupt_controller() {
  return peripheral_at<InterruptController>(0xE000E100U);
}

inline void enable_interrupt(std::uint32_t number) {
  interrupt_controller().set_enable[number / 32U].write(1U << (number % 32U));
}

/// An interrupt line that is still asserted stays pending and interrupts again once enabled.
inline void disable_interrupt(std::uint32_t number) {
  interrupt_controller().clear_enable[number / 32U].write(1U << (number % 32U));
}

/// Undoes the settings of a boot loader or debugger: no tick, no interrupt enabled or pending.
inline void disable_all_interrupts() {
  systick().control.write(0);
  system_control_block().interrupt_control.write(SystemControlBlock::kClearPendingTick);
  for (std::size_t i = 0; i < 8; ++i) {  // 240 lines, the maximum
    interrupt_controller().clear_enable[i].write(0xFFFFFFFFU);
    interrupt_controller().clear_pending[i].write(0xFFFFFFFFU);
  }
}

/// Makes an interrupt pending, like its device.
inline void trigger_interrupt(std::uint32_t number) {
  peripheral_at<Register>(0xE000EF00U).write(number);
}

}  // namespace fog::platform
