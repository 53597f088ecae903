#include "platform/cortex_m/memory_protection.hpp"

#include <cstdint>

#include "platform/cortex_m/system_control.hpp"
#include "platform/shared/linker_symbols.hpp"

namespace fog::platform {
namespace {

using Mpu = MemoryProtectionUnit;

/// 2^log2_bytes from `start`, which must be a multiple of that. Where regions overlap, the higher
/// number rules.
void set_region(std::uint32_t number, const void* start, std::uint32_t log2_bytes,
                std::uint32_t access) {
  const auto address = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(start));
  memory_protection_unit().region_base.write(address | Mpu::kRegionValid | number);
  memory_protection_unit().region_attributes.write(access | Mpu::kNormalMemory |
                                                   Mpu::size_field(log2_bytes) | Mpu::kEnable);
}

// The sizes are upper bounds of what the parts have: flash 1 MiB, RAM 128 KiB (linker/*.ld).
constexpr std::uint32_t kLog2FlashBytes = 20;
constexpr std::uint32_t kLog2RamBytes = 17;
constexpr std::uint32_t kLog2GuardBytes = 5;  // the smallest region there is

}  // namespace

// Peripherals keep the default map, which never executes from them. The trap handler runs without
// protection (kEnable alone, not for hard faults), so that the guard cannot stop its report.
void protect_memory() {
  set_region(0, fog_image_start, kLog2FlashBytes, Mpu::kReadOnly);
  set_region(1, fog_stack_guard, kLog2RamBytes, Mpu::kReadWrite | Mpu::kExecuteNever);
  set_region(2, fog_stack_guard, kLog2GuardBytes, Mpu::kNoAccess | Mpu::kExecuteNever);
  memory_protection_unit().control.write(Mpu::kEnable | Mpu::kDefaultMapElsewhere);
  asm volatile("dsb\n isb" ::: "memory");
}

}  // namespace fog::platform
