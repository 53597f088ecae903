#pragma once

#include <cstdint>

namespace fog::test {

/// What stands behind the registers of drivers that are compiled for this computer
/// (FOG_REGISTER_MODEL, firmware/platform/shared/bus.hpp): it is asked for every read and told
/// every write, by the address on the real bus. One at a time: the last that was made.
class RegisterModel {
 public:
  RegisterModel();
  virtual ~RegisterModel();
  RegisterModel(const RegisterModel&) = delete;
  RegisterModel& operator=(const RegisterModel&) = delete;

  virtual std::uint32_t read(std::uint32_t address) = 0;
  virtual void write(std::uint32_t address, std::uint32_t value) = 0;
  /// To a memory that is written like a register.
  virtual void write_byte(std::uint32_t address, std::uint8_t value) = 0;
};

/// The memory that a driver has given a DMA controller as `address`.
const volatile std::uint8_t* memory_at(std::uint32_t address);

}  // namespace fog::test
