#pragma once

#include <cstddef>

namespace fog::platform {

/// Fills the unused part of the stack with a pattern. Called by start-up, before deep calls.
void paint_stack();

/// Size of the reserved stack, and the part of it never written since start-up, in bytes.
std::size_t stack_bytes_reserved();
std::size_t stack_bytes_unused();

}  // namespace fog::platform
