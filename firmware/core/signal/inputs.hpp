#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/signal/quantities.hpp"

namespace fog {

/// Everything that a drift model can depend on: inputs of effects, expressions and the network. The
/// numbers are part of extension records and model tables (SPEC.md): add at the end, with a row in
/// kInputTable, and never change one.
enum class Input : std::uint8_t {
  temperature,       ///< coil sensor, in the trained range
  temperature_rate,  ///< its filtered derivative
  elapsed,           ///< time since power-on
  input_rate,        ///< about the axis; on the board, the rate that the gyro measures
  // From here on extension records carry the inputs, numbered from 0.
  temperature2,  ///< a second sensor
  magnetic,      ///< the field along the sensitive direction
  light_power,   ///< at the detector
  supply,
  vibration,  ///< rms
};
constexpr std::size_t kFirstExtensionInput = static_cast<std::size_t>(Input::temperature2);

/// Sinusoid of an extension input in the check of an export; for a second temperature, of its
/// difference from the first.
struct InputSwing {
  std::int32_t middle_milli;
  std::int32_t amplitude_milli;
  std::int32_t period_s;
};

/// Description of an input. Costs nothing in an image: it is for the host and for constants. Real
/// numbers are in thousandths, because the core has only integers.
struct InputDescription {
  Input input;
  const char* name;    ///< in option values: `fit --inputs`, `simulate --columns`
  const char* column;  ///< of a recording, ends with the unit; "": in no recording
  const char* symbol;  ///< in an expression
  const char* title;
  const char* unit;
  int fraction;  ///< fractional bits on the board
  /// Decimals in a CSV: finer than any sensor of the quantity. Time to 1 us numbers samples up to
  /// 500 kHz. 1e-5 degC is below half an LSB of the sensor stream (2^-16 degC), and 1e-6 deg/h
  /// below a thousandth of its rate LSB (2^-10 deg/h), so stream -> CSV -> stream restores the
  /// counts.
  int decimals;
  /// Lowest possible value; below it is a wrong unit, or a mark for "no value" such as -999.
  std::int64_t min_milli;
  std::int64_t max_milli;
  InputSwing swing;
};

inline constexpr InputDescription kInputTable[] = {
    {Input::temperature, "temperature", "temperature_degc", "T", "temperature", "degC",
     Temperature::fractional_bits, 5, -273'150, 1'000'000, InputSwing{}},
    {Input::temperature_rate, "temperature_rate", "", "dTdt", "temperature rate", "degC/min",
     TemperatureRate::fractional_bits, 6, 0, 0, InputSwing{}},
    {Input::elapsed, "elapsed", "time_s", "t", "time since power-on", "s", Elapsed::fractional_bits,
     6, -1'000'000'000'000'000, 1'000'000'000'000'000, InputSwing{}},
    {Input::input_rate, "input_rate", "input_rate_dph", "W", "input rate", "deg/h",
     Rate::fractional_bits, 6, -1'000'000'000'000, 1'000'000'000'000, InputSwing{}},
    {Input::temperature2, "temperature2", "temperature2_degc", "T2", "second temperature", "degC",
     ExtensionValue::fractional_bits, 5, -273'150, 1'000'000, InputSwing{0, 8'000, 3100}},
    {Input::magnetic, "magnetic", "magnetic_ut", "B", "magnetic field", "uT",
     ExtensionValue::fractional_bits, 5, -1'000'000'000'000, 1'000'000'000'000,
     InputSwing{0, 200'000, 1700}},
    {Input::light_power, "light_power", "light_power_uw", "P", "light power", "uW",
     ExtensionValue::fractional_bits, 5, -1'000'000'000'000, 1'000'000'000'000,
     InputSwing{500'000, 450'000, 2300}},
    {Input::supply, "supply", "supply_v", "V", "supply", "V", ExtensionValue::fractional_bits, 6,
     -1'000'000'000, 1'000'000'000, InputSwing{5'000, 500, 2900}},
    {Input::vibration, "vibration", "vibration_grms", "g", "vibration", "g rms",
     ExtensionValue::fractional_bits, 6, -1'000'000'000, 1'000'000'000,
     InputSwing{5'000, 5'000, 1300}},
};

constexpr std::size_t kInputs = sizeof kInputTable / sizeof kInputTable[0];
constexpr std::size_t kExtensionInputs = kInputs - kFirstExtensionInput;

constexpr const InputDescription& description_of(Input input) {
  return kInputTable[static_cast<std::size_t>(input)];
}
constexpr bool rows_are_in_order() {
  for (std::size_t i = 0; i < kInputs; ++i) {
    if (kInputTable[i].input != static_cast<Input>(i)) return false;
  }
  return true;
}
static_assert(rows_are_in_order(), "a row of kInputTable for each Input, in the enum's order");

constexpr bool is_extension(Input input) {
  return static_cast<std::size_t>(input) >= kFirstExtensionInput;
}
/// Numbers of extension records, from 0.
constexpr std::size_t extension_number(Input input) {
  return static_cast<std::size_t>(input) - kFirstExtensionInput;
}
constexpr Input extension_input(std::size_t number) {
  return static_cast<Input>(kFirstExtensionInput + number);
}

using InputMask = std::uint32_t;  ///< bit = Input
constexpr InputMask bit_of(Input input) {
  return InputMask{1} << static_cast<unsigned>(input);
}
constexpr bool has(InputMask mask, Input input) {
  return (mask & bit_of(input)) != 0U;
}
constexpr InputMask kAllInputs = (InputMask{1} << kInputs) - 1U;
constexpr InputMask kAllExtensionInputs = kAllInputs & ~(bit_of(Input::temperature2) - 1U);

/// Inputs of `mask` beside the coil temperature.
constexpr InputMask beside_temperature(InputMask mask) {
  return mask & ~(bit_of(Input::temperature) | bit_of(Input::temperature_rate));
}

}  // namespace fog
