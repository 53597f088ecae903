#pragma once

#include <cstddef>
#include <cstdint>

/// Files and exit of the computer that runs the emulator or debugger ("Semihosting for AArch32 and
/// AArch64", Arm). Without either the first call traps.
namespace fog::platform::semihosting {

using File = std::int32_t;
constexpr File kNoFile = -1;

enum class Mode : std::uint32_t { kRead = 1, kWrite = 5 };  // fopen's "rb" and "wb"

/// Opens `name`, `length` characters, relative to the emulator's working directory. Returns kNoFile
/// on failure.
File open(const char* name, std::size_t length, Mode mode);

template <std::size_t kSize>
File open(const char (&name)[kSize], Mode mode) {
  return open(name, kSize - 1, mode);
}

/// Returns the number of bytes read: fewer than `size` only at the end of the file.
std::size_t read(File file, std::uint8_t* destination, std::size_t size);

/// Returns whether all bytes were written.
bool write(File file, const std::uint8_t* source, std::size_t size);

/// Returns whether all data are in the file.
bool close(File file);

/// Writes a zero-terminated text to the emulator's or debugger's console.
void write_text(const char* text);

/// Ends the emulator with `status` as its exit code.
[[noreturn]] void exit(std::uint32_t status);

}  // namespace fog::platform::semihosting
