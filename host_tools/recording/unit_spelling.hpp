#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fogcomp::recording {

enum class Quantity : std::uint8_t {
  time,
  temperature,
  rate,
  field,
  power,
  voltage,
  vibration,
  counts,  ///< of a converter: a rate, once there is a scale factor
  other,   ///< nothing that a recording has
};

/// A unit as people write it, and how a recording's own is made of it:
/// ours = (theirs - offset) * factor / divisor.
struct Unit {
  Quantity quantity{};
  std::string words{};  ///< as messages have it: "deg/s"
  double factor = 1;
  double divisor = 1;  ///< so that 5 ms are 0.005 s to the last bit
  double offset = 0;

  bool is_ours() const { return factor == 1 && divisor == 1 && offset == 0; }
  double convert(double theirs) const { return (theirs - offset) * factor / divisor; }
  /// " x 3600", " / 1000", " - 273.15": behind the name of what is converted.
  std::string conversion_words() const;
};

/// The unit that `spelling` means, without regard to case: "deg/s", "°/s", "dps", "deg s^-1",
/// "degrees per second". Nothing where it means none.
std::optional<Unit> find_unit(std::string_view spelling);

/// The units of that quantity, as messages have them.
std::vector<std::string> units_of(Quantity quantity);

/// Whether it means that unit even behind a name without brackets ("coil_degc", "gyro_dps"): a
/// single letter does not.
bool is_telling(std::string_view spelling);

/// `text` as names and units are compared: lower case, ° as "deg", µ as "u", without quotes.
std::string folded(std::string_view text);

}  // namespace fogcomp::recording
