#pragma once

#include <cstdint>

// A board whose clock comes from an oscillator of 25 MHz.
namespace fog::platform {

constexpr std::uint32_t kCrystalHz = 25'000'000;
constexpr bool kCrystalIsOscillator = true;

}  // namespace fog::platform
