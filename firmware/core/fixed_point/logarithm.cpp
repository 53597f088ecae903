#include "core/fixed_point/logarithm.hpp"

#include "core/fixed_point/logarithm_table.hpp"

namespace fog {
namespace {

using Value = Fixed<std::int32_t, 30>;

constexpr int kNodeBits = 4;  // nodes every 1/16 between 1 and 2

// The test "LogarithmTable" recomputes these.
constexpr std::int64_t kLogOf2Q40 = 762123384786;
constexpr auto kThird = Value::from_raw(357913941);
constexpr auto kFifth = Value::from_raw(214748365);

// ln m for a mantissa 1 <= m <= 2 at 30 fractional bits (2 itself does not fit 32 bits): with c
// the nearest node and u = (m - c) / c, ln m = ln c + ln(1 + u). |u| <= 1/32, so the first
// neglected term is u^6/6 = 1.6e-10.
Value logarithm_of_mantissa(std::int64_t mantissa) {
  constexpr auto kOne = from_integer<Value>(1);
  constexpr auto kOneHalf = Value::from_raw(kOne.raw() / 2);
  constexpr auto kQuarter = Value::from_raw(kOne.raw() / 4);
  const auto product = [](auto a, auto b) { return round_to<Value>(a * b); };

  const std::int64_t node = round_shift(mantissa - kOne.raw(), 30 - kNodeBits);
  const std::int64_t centre = kOne.raw() + shift_left(node, 30 - kNodeBits);
  const auto distance = Value::from_raw(static_cast<std::int32_t>(mantissa - centre));
  const Value u = product(distance, Value::from_raw(kReciprocalTable[node]));
  Value series = kQuarter - product(u, kFifth);
  series = kThird - product(u, series);
  series = kOneHalf - product(u, series);
  series = kOne - product(u, series);
  return Value::from_raw(kLogarithmTable[node]) + product(u, series);
}

}  // namespace

Fixed<std::int32_t, 26> natural_logarithm(std::int64_t raw, int fraction) {
  const int exponent = 63 - __builtin_clzll(static_cast<unsigned long long>(raw));
  const std::int64_t mantissa =
      exponent > 30 ? round_shift(raw, exponent - 30) : shift_left(raw, 30 - exponent);
  // |exponent - fraction| <= 63, and the sum loses its 14 bits once.
  static_assert(63 * kLogOf2Q40 + shift_left(std::int64_t{INT32_MAX}, 10) < std::int64_t{1} << 46);
  const std::int64_t sum_q40 = (exponent - fraction) * kLogOf2Q40 +
                               shift_left(std::int64_t{logarithm_of_mantissa(mantissa).raw()}, 10);
  return Fixed<std::int32_t, 26>::from_raw(saturate<std::int32_t>(round_shift(sum_q40, 14)));
}

}  // namespace fog
