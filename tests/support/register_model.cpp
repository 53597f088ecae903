#include "support/register_model.hpp"

#include <array>
#include <map>
#include <stdexcept>
#include <vector>

#include "platform/shared/bus.hpp"

namespace fog {
namespace {

test::RegisterModel* plugged = nullptr;

// Registers need addresses for references; the model holds their contents.
constexpr std::uint32_t kPageBytes = 4096;
using Page = std::array<std::uint8_t, kPageBytes>;
std::map<std::uint32_t, Page>& pages() {
  static std::map<std::uint32_t, Page> all;
  return all;
}

bool find_register(const volatile void* memory, std::uint32_t& address) {
  const auto place = reinterpret_cast<std::uintptr_t>(memory);
  for (const auto& [page, bytes] : pages()) {
    const auto start = reinterpret_cast<std::uintptr_t>(bytes.data());
    if (place < start || place >= start + kPageBytes) continue;
    address = page * kPageBytes + static_cast<std::uint32_t>(place - start);
    return true;
  }
  return false;
}

std::uint32_t register_address(const volatile std::uint32_t& reg) {
  std::uint32_t address = 0;
  if (!find_register(&reg, address)) throw std::logic_error("not a register");
  return address;
}

// Buffers of drivers, which on this computer lie beyond 32 bits.
constexpr std::uint32_t kRamStart = 0x20000000;
constexpr std::uint32_t kBufferSpacing = 0x10000;
std::vector<const volatile std::uint8_t*>& buffers() {
  static std::vector<const volatile std::uint8_t*> all;
  return all;
}

}  // namespace

namespace platform::bus {

std::uint32_t read(const volatile std::uint32_t& reg) {
  return plugged->read(register_address(reg));
}

void write(volatile std::uint32_t& reg, std::uint32_t value) {
  plugged->write(register_address(reg), value);
}

void write_byte(std::uint32_t address, std::uint8_t value) {
  plugged->write_byte(address, value);
}

void* at(std::uint32_t address) {
  return &pages()[address / kPageBytes][address % kPageBytes];
}

std::uint32_t address_of(const volatile void* memory) {
  std::uint32_t address = 0;
  if (find_register(memory, address)) return address;
  buffers().push_back(static_cast<const volatile std::uint8_t*>(memory));
  return kRamStart + static_cast<std::uint32_t>(buffers().size() - 1) * kBufferSpacing;
}

}  // namespace platform::bus

namespace test {

RegisterModel::RegisterModel() {
  plugged = this;
}

RegisterModel::~RegisterModel() {
  plugged = nullptr;
}

const volatile std::uint8_t* memory_at(std::uint32_t address) {
  const std::uint32_t offset = address - kRamStart;
  return buffers().at(offset / kBufferSpacing) + offset % kBufferSpacing;
}

}  // namespace test
}  // namespace fog
