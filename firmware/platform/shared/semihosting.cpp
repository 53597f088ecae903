#include "platform/shared/semihosting.hpp"

#include <array>

#include "platform/shared/semihosting_call.hpp"

namespace fog::platform::semihosting {
namespace {

enum class Operation : std::uint32_t {
  kOpen = 0x01,
  kClose = 0x02,
  kWriteText = 0x04,
  kWrite = 0x05,
  kRead = 0x06,
  kExitExtended = 0x20,
};

constexpr std::uint32_t kApplicationExit = 0x20026;

using Arguments = std::array<std::uint32_t, 3>;

std::uint32_t address(const void* pointer) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(pointer));
}

std::int32_t call(Operation operation, const Arguments& arguments) {
  return semihosting_call(static_cast<std::uint32_t>(operation), arguments.data());
}

}  // namespace

File open(const char* name, std::size_t length, Mode mode) {
  return call(Operation::kOpen, {address(name), static_cast<std::uint32_t>(mode), length});
}

// Read and write return the number of bytes NOT transferred.
std::size_t read(File file, std::uint8_t* destination, std::size_t size) {
  const std::int32_t missing =
      call(Operation::kRead, {static_cast<std::uint32_t>(file), address(destination), size});
  const auto not_read = static_cast<std::size_t>(missing);
  return not_read <= size ? size - not_read : 0;
}

bool write(File file, const std::uint8_t* source, std::size_t size) {
  return call(Operation::kWrite, {static_cast<std::uint32_t>(file), address(source), size}) == 0;
}

bool close(File file) {
  return call(Operation::kClose, {static_cast<std::uint32_t>(file)}) == 0;
}

void write_text(const char* text) {
  semihosting_call(static_cast<std::uint32_t>(Operation::kWriteText),
                   static_cast<const std::uint32_t*>(static_cast<const void*>(text)));
}

void exit(std::uint32_t status) {
  for (;;) call(Operation::kExitExtended, {kApplicationExit, status});
}

}  // namespace fog::platform::semihosting
