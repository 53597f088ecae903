#pragma once

#include <cstddef>
#include <cstdint>

namespace fog {

/// What an effect can depend on beside the coil's temperature. The first kExtensionInputs reach the
/// board in extension records (SPEC.md), where the number is that of the enum: add before
/// input_rate, never move one.
enum class Input : std::uint8_t {
  temperature2,  ///< degC, a second sensor
  magnetic,      ///< uT, the field along the sensitive direction
  light_power,   ///< uW at the detector
  supply,        ///< V
  vibration,     ///< g rms
  input_rate,    ///< deg/h about the axis; on the board, what the gyro itself measures
  elapsed,       ///< time since power-on
};
constexpr std::size_t kExtensionInputs = 5;
constexpr std::size_t kInputs = 7;

using InputMask = std::uint32_t;  ///< bit = Input
constexpr InputMask bit_of(Input input) {
  return InputMask{1} << static_cast<unsigned>(input);
}
constexpr bool has(InputMask mask, Input input) {
  return (mask & bit_of(input)) != 0U;
}
constexpr InputMask kAllExtensionInputs = (InputMask{1} << kExtensionInputs) - 1U;

}  // namespace fog
