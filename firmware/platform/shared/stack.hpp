#pragma once

#include <cstddef>

namespace fog::platform {

/// Fills the unused part of the stack with a pattern. Start-up calls it, before anything ran deep.
void paint_stack();

/// Bytes of the reserved stack, and of those how many have never been written since start-up.
std::size_t stack_bytes_reserved();
std::size_t stack_bytes_unused();

}  // namespace fog::platform
