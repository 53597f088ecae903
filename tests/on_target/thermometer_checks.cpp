#include "core/bytes/crc.hpp"
#include "core/thermometer/ds18b20.hpp"
#include "core/thermometer/platinum.hpp"
#include "on_target/checks.hpp"

namespace fog::checks {
namespace {

// Ratio * 10^6 of IEC 60751's formula at whole degrees.
struct Point {
  std::int32_t degc;
  std::int32_t millionth_ratio;
};
constexpr Point kStandard[] = {{-70, 723345}, {0, 1000000}, {100, 1385055}, {130, 1498319}};

bool within_a_thousandth(std::int32_t q16, std::int32_t degc) {
  const std::int32_t off = q16 - degc * 65536;
  return -66 < off && off < 66;
}

}  // namespace

bool platinum_has_the_temperatures_of_its_standard() {
  for (const Point& point : kStandard) {
    const auto raw = round_divide(std::int64_t{point.millionth_ratio} * (1 << 28), 1000000);
    const auto ratio = ResistanceRatio::from_raw(static_cast<std::int32_t>(raw));
    if (!within_a_thousandth(platinum_temperature(ratio).raw(), point.degc)) return false;
  }
  return true;
}

bool ds18b20_scratchpads_are_judged() {
  Scratchpad good{0x5E, 0xFF, 0x5F, 0xA6, 0x7F, 0xFF, 0x0C, 0x10, 0};  // -10.125 degC
  good[8] = crc8(good.data(), 8);
  Scratchpad after_power_on{0x50, 0x05, 0x4B, 0x46, 0x7F, 0xFF, 0x0C, 0x10, 0};
  after_power_on[8] = crc8(after_power_on.data(), 8);
  Temperature temperature{};
  if (!decode_scratchpad(good, temperature) || temperature.raw() != -162 * 4096) return false;
  if (decode_scratchpad(after_power_on, temperature)) return false;
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    Scratchpad damaged = good;
    damaged[bit / 8] = static_cast<std::uint8_t>(damaged[bit / 8] ^ (1U << (bit % 8)));
    if (decode_scratchpad(damaged, temperature)) return false;
  }
  return true;
}

}  // namespace fog::checks
