#pragma once

#include <cstdint>

/// How registers are reached. On a target: at their addresses. In the tests of the drivers on a
/// computer (FOG_REGISTER_MODEL): a model of the hardware sees every access and answers
/// (tests/support/register_model.hpp), so that what no emulator has can be shown to be handled.
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
/// To a memory that is written like a register: a flash. Before the next access to anything.
inline void write_byte(std::uint32_t address, std::uint8_t value) {
  *reinterpret_cast<volatile std::uint8_t*>(address) = value;
  __atomic_thread_fence(__ATOMIC_SEQ_CST);
}
inline void* at(std::uint32_t address) {
  return reinterpret_cast<void*>(address);
}
/// What a DMA controller is told.
inline std::uint32_t address_of(const volatile void* memory) {
  return reinterpret_cast<std::uintptr_t>(memory);
}

#endif

}  // namespace fog::platform::bus
