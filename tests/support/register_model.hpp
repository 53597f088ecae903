#pragma once

#include <cstdint>

namespace fog::test {

/// Model of the hardware behind the registers of drivers compiled for this computer
/// (FOG_REGISTER_MODEL, firmware/platform/shared/bus.hpp): it handles every read and write, by the
/// address on the real bus. One at a time: the last one constructed.
class RegisterModel {
 public:
  RegisterModel();
  virtual ~RegisterModel();
  RegisterModel(const RegisterModel&) = delete;
  RegisterModel& operator=(const RegisterModel&) = delete;

  virtual std::uint32_t read(std::uint32_t address) = 0;
  virtual void write(std::uint32_t address, std::uint32_t value) = 0;
  /// A write to a memory that behaves like a register.
  virtual void write_byte(std::uint32_t address, std::uint8_t value) = 0;
};

/// The memory whose address a driver has given a DMA controller.
const volatile std::uint8_t* memory_at(std::uint32_t address);

}  // namespace fog::test
