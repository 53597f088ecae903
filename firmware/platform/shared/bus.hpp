#pragma once

#include <cstdint>

/// Access to registers. On a target: at their addresses. In the driver tests on a computer
/// (FOG_REGISTER_MODEL): a model of the hardware handles every access
/// (tests/support/register_model.hpp), for conditions that no emulator provides.
namespace fog::platform::bus {

#ifdef FOG_REGISTER_MODEL

std::uint32_t read(const volatile std::uint32_t& reg);
void write(volatile std::uint32_t& reg, std::uint32_t value);
void write_byte(std::uint32_t address, std::uint8_t value);
void* at(std::uint32_t address);
std::uint32_t address_of(const volatile void* memory);

#else

inline std::uint32_t read(const volatile std::uint32_t& reg) {
  return reg;
}
inline void write(volatile std::uint32_t& reg, std::uint32_t value) {
  reg = value;
}
/// Writes a memory that behaves like a register (flash), in order with all other accesses.
inline void write_byte(std::uint32_t address, std::uint8_t value) {
  *reinterpret_cast<volatile std::uint8_t*>(address) = value;
  __atomic_thread_fence(__ATOMIC_SEQ_CST);
}
inline void* at(std::uint32_t address) {
  return reinterpret_cast<void*>(address);
}
/// Address for a DMA controller.
inline std::uint32_t address_of(const volatile void* memory) {
  return reinterpret_cast<std::uintptr_t>(memory);
}

#endif

}  // namespace fog::platform::bus
