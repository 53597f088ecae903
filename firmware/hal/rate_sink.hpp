#pragma once

#include <cstddef>
#include <cstdint>

namespace fog::hal {

/// Sends `size` bytes of output frames to the user. Returns when all are handed to the line.
void write_output_stream(const std::uint8_t* bytes, std::size_t size);

/// Sends a zero-terminated ASCII text to the console: the boot message, the reason of a refusal.
/// The console is a separate port, so the output stream contains only frames.
void write_console(const char* text);

}  // namespace fog::hal
