#include "platform/cortex_m/memory_protection.hpp"

#include <cstdint>

#include "platform/cortex_m/system_control.hpp"
#include "platform/shared/linker_symbols.hpp"

namespace fog::platform {
namespace {

using Mpu = MemoryProtectionUnit;

/// A region from `start`, a multiple of its size. Where regions overlap, the higher number has
/// priority.
void set_region(std::uint32_t number, const void* start, std::uint32_t attributes) {
  const auto address = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(start));
  memory_protection_unit().region_base.write(address | Mpu::kRegionValid | number);
  memory_protection_unit().region_attributes.write(attributes);
}

constexpr std::uint32_t attributes(std::uint32_t access) {
  return access | Mpu::kNormalMemory | Mpu::kEnable;
}

/// `region_size`: linker symbol whose address is the size field; added by the linker.
std::uint32_t attributes(std::uint32_t access, const std::uint8_t* region_size) {
  return reinterpret_cast<std::uintptr_t>(region_size + attributes(access));
}

constexpr std::uint32_t kLog2GuardBytes = 5;  // smallest possible region
constexpr std::uint32_t kRegions = 8;         // those of both parts; the first ones are in use

}  // namespace

// Peripherals keep the default map, which never executes from them. The trap handler runs without
// protection (kEnable alone does not cover hard faults), so that the guard cannot stop its report.
void protect_memory() {
  memory_protection_unit().control.write(0);  // a boot loader may have left it on, with its regions
  set_region(0, fog_image_start, attributes(Mpu::kReadOnly, fog_flash_region_size));
  set_region(1, fog_stack_guard,
             attributes(Mpu::kReadWrite | Mpu::kExecuteNever, fog_ram_region_size));
  set_region(2, fog_stack_guard,
             attributes(Mpu::kNoAccess | Mpu::kExecuteNever) | Mpu::size_field(kLog2GuardBytes));
  for (std::uint32_t number = 3; number < kRegions; ++number) set_region(number, nullptr, 0);
  memory_protection_unit().control.write(Mpu::kEnable | Mpu::kDefaultMapElsewhere);
  asm volatile("dsb\n isb" ::: "memory");
}

void allow_writes(const void* start, bool allowed) {
  constexpr std::uint32_t kLog2Bytes = 14;
  set_region(
      3, start,
      allowed ? attributes(Mpu::kReadWrite | Mpu::kExecuteNever) | Mpu::size_field(kLog2Bytes) : 0);
  asm volatile("dsb\n isb" ::: "memory");
}

}  // namespace fog::platform
