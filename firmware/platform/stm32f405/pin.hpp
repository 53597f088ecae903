#pragma once

#include <cstdint>

namespace fog::platform {

enum class Port : std::uint8_t { kA, kB, kC };

/// A pin and its alternate function number (data sheet, table 9).
struct Pin {
  Port port;
  std::uint8_t number;
  std::uint8_t alternate_function;
};

}  // namespace fog::platform
